#include "cosim/model/paper/pulse_width.hpp"

#include <algorithm>

#include "controller/regs/pulse_width_regs.hpp"

namespace armature::cosim::model {
namespace width_regs = armature::regs::pulse_width;

// A set is always pending, so that the heartbeat inverts with each trigger. There is no watchdog.
StopControl::Inputs PulseWidth::stop_inputs(bool trigger) const {
  return {.pin_low = pins_.ago(2).estop,
          .stop = stop_order_,
          .clear_estop = clear_order_,
          .trigger = trigger,
          .pending = true};
}

Answer PulseWidth::edge(Cycles at, const Strobes& access, const PulseInputs& in) {
  const StopControl::Inputs control = stop_inputs(in.trigger);
  const bool stopped = stop_.stops(control);
  Answer answer;
  if (gated_clock_stopped_) {
    run_axes(at, in.trigger, stopped);
    pins_.sample(arm_pins(in));
    find_wake(at, in);
    return answer;
  }
  if (access.read) answer = read(at, word_offset(access.raddr));
  servo_pins_ = stop_.estop() ? std::uint8_t{0} : servo_on_;
  if (in.trigger) {
    for (std::size_t i = 0; i < kAxes; ++i) emitted_[i] = axes_[i].emitted();
  }
  run_axes(at, in.trigger, stopped);
  armed_ = stopped ? std::uint8_t{0} : static_cast<std::uint8_t>(armed_ | written_);
  const StopControl::Events events = stop_.edge(at, control);
  pins_.sample(arm_pins(in));
  written_ = 0;
  stop_order_ = clear_order_ = false;
  cleared_faults_ = 0;
  if (access.write) answer.werr = write(access);
  faults_.edge(at, events.estop ? width_regs::kFaultEstopMask : 0u, cleared_faults_);
  find_wake(at, in);
  return answer;
}

void PulseWidth::run_axes(Cycles at, bool trigger, bool stopped) {
  if (!trigger && !stopped && at < axes_wake_at_) return;
  std::uint8_t step = 0, dir = 0;
  for (std::size_t i = 0; i < kAxes; ++i) {
    axes_[i].edge(at, trigger, stopped, (armed_ >> i & 1) != 0 ? widths_[i] : 0);
    step |= static_cast<std::uint8_t>(axes_[i].step() << i);
    dir |= static_cast<std::uint8_t>(axes_[i].positive() << i);
  }
  step_ = step;
  dir_ = dir;
}

void PulseWidth::find_wake(Cycles at, const PulseInputs& in) {
  const StopControl::Inputs control = stop_inputs(in.trigger);
  axes_wake_at_ = kNever;
  bool running = false;
  for (const WidthAxis& axis : axes_) {
    axes_wake_at_ = std::min(axes_wake_at_, axis.wakes_at());
    running = running || axis.is_running();
  }
  const bool stops = stop_.stops(control);
  const bool free_due = in.trigger || !pins_.are_settled(arm_pins(in)) || (stops && running);
  if (gated_clock_stopped_) {
    wakes_at_ = free_due ? at + Cycles{1} : axes_wake_at_;
    return;
  }
  const bool due = free_due || written_ != 0 || stop_order_ || clear_order_ || (stops && armed_ != 0) ||
                   servo_pins_ != (stop_.estop() ? 0 : servo_on_);
  wakes_at_ = due ? at + Cycles{1} : std::min(axes_wake_at_, stop_.wakes_at(at, control));
}

Answer PulseWidth::read(Cycles at, std::uint32_t offset) const {
  using armature::regs::insert;
  if (const auto axis = element_at(offset, width_regs::kWidthOffset)) return {.rdata = widths_[*axis]};
  if (const auto axis = element_at(offset, width_regs::kEmittedOffset)) return {.rdata = emitted_[*axis]};
  const ArmPins& pins = pins_.ago(2);
  const auto word = [](auto... fields) { return Answer{.rdata = (0u | ... | fields)}; };
  switch (offset) {
    case width_regs::kIdOffset:
      return word(width_regs::kIdWord);
    case width_regs::kCtrlOffset:
      return word(insert(0, width_regs::kCtrlServoOn, servo_on_));
    case width_regs::kStatusOffset:
      return word(insert(0, width_regs::kStatusEstop, stop_.estop()),
                  insert(0, width_regs::kStatusEstopPin, pins.estop), insert(0, width_regs::kStatusArmed, armed_));
    case width_regs::kEstopOffset:
      return word(0u);
    case width_regs::kFaultOffset:
      return word(faults_.flags());
    case width_regs::kTimeOffset:
      return word(static_cast<std::uint32_t>(at.value() - 1));
    case width_regs::kSwitchesOffset:
      return word(insert(0, width_regs::kSwitchesHome, pins.home),
                  insert(0, width_regs::kSwitchesLimitPos, pins.limit_pos),
                  insert(0, width_regs::kSwitchesLimitNeg, pins.limit_neg));
    case width_regs::kDrivesOffset:
      return word(insert(0, width_regs::kDrivesAlarm, pins.drive_alarm),
                  insert(0, width_regs::kDrivesInPosition, pins.in_position),
                  insert(0, width_regs::kDrivesServoOn, servo_pins_));
    case width_regs::kFaultTimeOffset:
      return word(faults_.time(0));
    default:
      return kUnmappedRead;
  }
}

bool PulseWidth::write(const Strobes& access) {
  const std::uint32_t offset = word_offset(access.waddr);
  const std::uint32_t ones = merged(0, access);  // bits that are written as 1
  if (const auto axis = element_at(offset, width_regs::kWidthOffset)) {
    widths_[*axis] = merged(widths_[*axis], access);
    if (access.wstrb != 0) written_ = static_cast<std::uint8_t>(1u << *axis);
    return false;
  }
  switch (offset) {
    case width_regs::kCtrlOffset:
      servo_on_ = static_cast<std::uint8_t>(merged(servo_on_, access) & width_regs::kCtrlServoOnMask);
      return false;
    case width_regs::kEstopOffset:
      stop_order_ = (ones & width_regs::kEstopStopMask) != 0;
      clear_order_ = (ones & width_regs::kEstopClearEstopMask) != 0;
      return false;
    case width_regs::kFaultOffset:
      cleared_faults_ = ones;
      return false;
    default:
      return true;
  }
}

}  // namespace armature::cosim::model
