#include <bit>
#include <cstdint>
#include <utility>

#include "cosim/kernel/simulation.hpp"

namespace armature::cosim {

// Returns whether a pin has changed that concerns more than the plant.
bool Simulation::on_pins_changed() {
  const SocOutputs& out = soc_->outputs();
  SocOutputs others = std::exchange(seen_, out);
  others.step = out.step;
  others.dir = out.dir;
  others.heartbeat = out.heartbeat;
  if (!wave_.is_open()) others.trigger = out.trigger;  // a waveform shows the number of the tick
  const bool triggers = out.trigger && !trigger_was_high_;
  const Cycles here = now();
  if (triggers && ticks_.on_trigger(here)) drive_inputs();
  plant_.on_outputs(here, out);
  conservation_.on_outputs(here, out);
  if (serial_) serial_->on_level(here, out.uart_txd);
  check_pulses();
  if (out.gpio != tool_outputs_) report_outputs(out.gpio);
  report_servo_enables();
  if (triggers) on_trigger();
  trigger_was_high_ = out.trigger;
  const bool faults_begin = triggers && begin_faults_of_conditions();
  const bool concern_others = faults_begin || others != out;
  show_interrupts();
  return concern_others;
}

// Tells the processor the interrupt levels, if they have changed.
void Simulation::show_interrupts() {
  const std::uint8_t levels = injector_.seen_interrupts(seen_.irq);
  if (levels == interrupts_) return;
  begin_tick();  // the core that wakes may run ahead in it
  processor_->set_interrupts(interrupts_ = levels, now());
  read_host_memory();
}

void Simulation::report_servo_enables() {
  const std::uint8_t levels = plant_.servo_enables();
  if (levels != servo_on_) listener_.on_signal(ServoEnables{servo_on_ = levels}, now());
}

void Simulation::report_outputs(std::uint16_t levels) {
  for (unsigned changed = levels ^ std::exchange(tool_outputs_, levels); changed != 0; changed &= changed - 1) {
    const int bit = std::countr_zero(changed);
    listener_.on_signal(OutputLevel{.pin = bit + 1, .level = ((levels >> bit) & 1) != 0}, now());
  }
}

}  // namespace armature::cosim
