#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cosim/kernel/simulation.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {

void Simulation::on_trigger() {
  const Cycles here = now();
  conservation_.on_trigger(here);
  if (conservation_.violation()) fail_conservation();
  if (belt_) publish_belt();
  // The time before the first trigger was start-up, not a tick.
  if (triggers_ == 0) processor_->reset_worst_tick();

  const std::uint8_t servo_on = soc_->outputs().servo_on;
  row_.tick = triggers_++;
  row_.cycle = here.value();
  row_.stopped = servo_was_on_ && servo_on == 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    row_.pin_pulses[axis] = conservation_.pin_pulses(axis);
    row_.pulses_to_drop[axis] = plant_.pulses_to_drop(axis);
    row_.motor_counts[axis] = plant_.motor_counts(axis).value();
    row_.first_rise[axis] = conservation_.edges_of_tick(axis).first_rise.value();
    row_.turned[axis] = conservation_.edges_of_tick(axis).turned.value();
    const Plant::MotorStep motor = plant_.motor_step_before(axis, here);
    row_.motor_from[axis] = motor.start.value();
    row_.motor_to[axis] = motor.target.value();
  }
  row_.load_lead_deg = plant_.load_lead_deg();
  const std::array<CoreLoad, 2> load = load_until_now();
  for (std::size_t core = 0; core < load.size(); ++core) {
    row_.load[core] = {.awake_cycles = load[core].awake_cycles - load_before_[core].awake_cycles,
                       .bus_cycles = load[core].bus_cycles - load_before_[core].bus_cycles,
                       .instructions = load[core].instructions - load_before_[core].instructions};
  }
  load_before_ = load;
  servo_was_on_ = servo_was_on_ || servo_on != 0;
  row_.tool_point.reset();
  listener_.on_row(row_);
}

// They begin in the next cycle, as any other action of the script.
bool Simulation::begin_faults_of_conditions() {
  const std::vector<FaultSpec> due = conditions_.due(row_);
  for (const FaultSpec& fault : due) script_.insert(now() + Cycles{1}, fault);
  return !due.empty();
}

// Since the beginning of the run.
std::array<CoreLoad, 2> Simulation::load_until_now() const {
  std::array<CoreLoad, 2> load;
  const Cycles here = now();
  for (std::size_t core = 0; core < load.size(); ++core) {
    const bool on_bus = access_ && access_->core == static_cast<int>(core);
    load[core].awake_cycles = processor_->awake(static_cast<int>(core), here).value();
    load[core].instructions = processor_->instructions(static_cast<int>(core));
    load[core].bus_cycles = (bus_time_[core] + (on_bus ? here - access_since_ : Cycles{})).value();
  }
  return load;
}

void Simulation::publish_belt() {
  if (const auto sample = belt_->sample(Ticks{triggers_}, to_seconds(now()))) host_.publish_belt(sample->counts);
}

}  // namespace armature::cosim
