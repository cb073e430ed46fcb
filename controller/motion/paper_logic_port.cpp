#include "controller/motion/paper_logic_port.hpp"

#include <algorithm>

#include "controller/base/timebase.hpp"

namespace armature {

bool PaperLogicPort::identified() noexcept {
  return pulse_width_.identified() && switch_.identified() && decoder_.identified();
}

void PaperLogicPort::start(const RobotModel& robot) noexcept {
  axis_count_ = robot.axis_count;
  dir_hold_ = largest_of(robot, &AxisModel::dir_hold_cycles);
  const Cycles min_high = largest_of(robot, &AxisModel::min_step_high_cycles);
  const Cycles min_half = std::max(min_high, largest_of(robot, &AxisModel::min_step_low_cycles));
  const Cycles dir_setup = largest_of(robot, &AxisModel::dir_setup_cycles);
  widths_.emplace(HalfPeriodLimits{.min_width = min_half, .min_high = min_high, .dir_hold = dir_hold_});
  turning_.emplace(
      HalfPeriodLimits{.min_width = std::max(min_half, dir_setup), .min_high = min_high, .dir_hold = dir_hold_});

  switch_.select(selected_);
  pulse_width_.clear_estop_flag();
  read_uncounted_axes();
  if (uncounted_axes_ == 0) {
    commit({});
    if (drives_at_start_) set_servo(true);
  }
  // After the accesses above the decoder's filter has passed any edge that the switch caused.
  decoder_.clear_illegal_flag();
  timer_.start(kTickCycles);
}

const LogicInput& PaperLogicPort::sample() noexcept {
  const PulseWidth::Drives drives = pulse_width_.drives();  // before the status, which says why an enable is low
  const PulseWidth::Status status = pulse_width_.status();
  const PulseWidth::Switches switches = pulse_width_.switches();
  const auto triggered_after_commit = static_cast<std::int32_t>(decoder_.trigger_time() - written_at_);
  const bool pending = triggered_after_commit <= 0;
  input_.status = {.estop = status.estop,
                   .watchdog = false,
                   .estop_pin = status.estop_pin,
                   .pending = pending,
                   .sequence = static_cast<std::uint16_t>(pending ? sequence_ - 1 : sequence_)};
  input_.switches = {.home = switches.home, .limit_pos = switches.limit_pos, .limit_neg = switches.limit_neg};
  input_.drives = {.alarm = drives.alarm, .in_position = drives.in_position, .servo_on = drives.servo_on};
  input_.always_counted = multiplexed() ? std::uint8_t{0} : static_cast<std::uint8_t>(1u << selected_);
  const bool illegal = !multiplexed() && decoder_.illegal_flag();
  input_.encoder_faults = {.illegal = illegal ? input_.always_counted : std::uint8_t{0}, .index = 0};
  read_position();
  read_emitted();
  account_for_emission();
  return input_;
}

void PaperLogicPort::commit(const PerAxis<Pulses>& counts) noexcept {
  ++sequence_;
  switch_if_due();
  active_ = written_;  // if this commit is late, the trigger that it missed used the old widths
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const Cycles width = choose_width(axis, counts[axis]);
    if (width != Cycles{0}) direction_[axis] = width > Cycles{0} ? 1 : -1;
    written_[axis] = width;
    accounted_[axis] += counts[axis];
  }
  pulse_width_.set_widths(written_);
  written_at_ = pulse_width_.time();
}

void PaperLogicPort::clear_faults() noexcept {
  pulse_width_.clear_stop();
  pulse_width_.clear_estop_flag();
  decoder_.clear_illegal_flag();
  if (uncounted_axes_ != 0) read_uncounted_axes();
}

const PerAxis<Pulses>& PaperLogicPort::emitted() noexcept {
  read_emitted();
  accounted_ = emitted_;
  return emitted_;
}

Cycles PaperLogicPort::choose_width(std::size_t axis, Pulses count) const noexcept {
  if (count == Pulses{0} || !widths_) return Cycles{0};
  const int direction = count > Pulses{0} ? 1 : -1;
  if (direction == direction_[axis]) return widths_->width(count);
  const Cycles before{std::max(written_[axis], -written_[axis])};
  if (before != Cycles{0} && tick_end(before).low_since < dir_hold_) return Cycles{0};
  return turning_->width(count);
}

void PaperLogicPort::switch_if_due() noexcept {
  if (!multiplexed()) return;
  selected_for_ += Ticks{1};
  if (selected_for_ < encoders_.switch_every) return;
  selected_for_ = Ticks{0};
  selected_ = (selected_ + 1) % axis_count_;
  // The six widths are written after this: when the time stamp is read behind them, the filter has settled.
  switch_.select(selected_);
  position_valid_ = false;
}

void PaperLogicPort::read_position() noexcept {
  const std::int32_t position = decoder_.position();
  if (position_valid_) {
    input_.encoder[selected_] += Counts{unwrapped(position_, position) - position_};
  }
  position_valid_ = position_valid_ || !input_.status.pending;
  position_ = position;
}

void PaperLogicPort::read_emitted() noexcept {
  const PerAxis<std::int32_t> low = pulse_width_.emitted();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    emitted_[axis] = Pulses{unwrapped(emitted_[axis].value(), low[axis])};
  }
}

void PaperLogicPort::account_for_emission() noexcept {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    Pulses coming = pulses_of_width(written_[axis]);
    if (input_.status.pending) coming += pulses_of_width(active_[axis]);
    const Pulses out = emitted_[axis] + coming;
    input_.not_emitted[axis] = accounted_[axis] - out;
    accounted_[axis] = out;
  }
}

void PaperLogicPort::read_uncounted_axes() noexcept {
  uncounted_axes_ = decoder_.known() ? std::uint8_t{0} : static_cast<std::uint8_t>(1u << selected_);
}

}  // namespace armature
