#include "controller/activity/tool_io.hpp"

#include "controller/base/timebase.hpp"
#include "controller/drivers/axi_gpio.hpp"

namespace armature {

void ToolIo::on_interrupt(RegisterBus& bus) noexcept {
  bus.charge(Work::kInterruptEntry);
  changed_ = true;
}

void ToolIo::set(const SetOutput& output, RegisterBus& bus) noexcept {
  AxiGpio{bus}.set_output(output.pin, output.level);
}

bool ToolIo::level(std::uint8_t pin, bool output, RegisterBus& bus) noexcept {
  AxiGpio gpio{bus};
  return output ? (gpio.outputs() >> (pin - 1U) & 1U) != 0 : gpio.input(pin);
}

void ToolIo::begin(const WaitInput& wait, RegisterBus& bus) noexcept {
  wait_ = wait;
  began_ = bus.now();
  AxiGpio{bus}.enable_input_interrupt();
  waiting_ = changed_ = true;
}

ToolIo::WaitState ToolIo::sample(RegisterBus& bus) noexcept {
  if (changed_) {
    AxiGpio gpio{bus};
    // This order loses no change: a change between the two accesses is read now and raises the interrupt again.
    gpio.acknowledge_inputs();
    changed_ = false;
    if (gpio.input(wait_.pin) == wait_.level) {
      waiting_ = false;
      return WaitState::kReached;
    }
  }
  if (wait_.timeout == Ticks{} || bus.now() - began_ < Cycles{wait_.timeout.value() * kTickCycles.value()})
    return WaitState::kPending;
  waiting_ = false;
  return WaitState::kTimedOut;
}

}  // namespace armature
