#include "controller/motion/count_logic_port.hpp"

#include "controller/base/timebase.hpp"

namespace armature {
namespace {

constexpr PulseTrain::Faults kAllFlags{
    .estop = true, .watchdog = true, .underrun = true, .residual = true, .clipped = true, .recommit = true};
constexpr Encoder::Faults kAllEncoderFlags{.illegal = PulseTrain::kAllAxes, .index = PulseTrain::kAllAxes};

}  // namespace

bool CountLogicPort::identified() noexcept {
  return pulse_train_.identified() && encoder_.identified();
}

void CountLogicPort::start(const RobotModel& robot) noexcept {
  pulse_train_.configure({.tick = kTickCycles,
                          .dir_setup = largest_of(robot, &AxisModel::dir_setup_cycles),
                          .dir_hold = largest_of(robot, &AxisModel::dir_hold_cycles)});
  unsigned zero_axes = 0;
  for (std::size_t axis = 0; axis < kAxes && starts_at_zero_; ++axis) {
    zero_axes |= (robot.axes[axis].index_at_zero ? 1u : 0u) << axis;
  }
  encoder_.configure(make_per_axis([&](std::size_t axis) { return robot.axes[axis].counts_per_rev; }),
                     static_cast<std::uint8_t>(zero_axes));
  pulse_train_.clear(kAllFlags);
  encoder_.clear(kAllEncoderFlags);
  read_uncounted_axes();
  read_residual();
  if (uncounted_axes_ == 0) {
    commit({});
    if (drives_at_start_) set_servo(true);
  }
  timer_.start(kTickCycles);
  input_.underruns = pulse_train_.underruns();  // constant before the first trigger
}

const LogicInput& CountLogicPort::sample() noexcept {
  // Flags first: an event between two reads is then found now or in the next sample.
  const PulseTrain::Faults flags = pulse_train_.faults();
  input_.drives = pulse_train_.drives();  // before the status, which says why an enable is low
  input_.status = pulse_train_.status();
  input_.switches = pulse_train_.switches();
  input_.encoder_faults = encoder_.faults();
  const PerAxis<std::int32_t> positions = encoder_.positions();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    input_.encoder[axis] = position(axis, positions[axis]);
  }

  input_.new_underruns = 0;
  input_.not_emitted = {};
  if (flags.underrun || flags.residual) {
    pulse_train_.clear({.underrun = flags.underrun, .residual = flags.residual});
    if (flags.residual) read_residual();
    if (flags.underrun) {
      const std::uint32_t underruns = pulse_train_.underruns();
      input_.new_underruns = underruns - input_.underruns;
      input_.underruns = underruns;
    }
  }
  return input_;
}

// From the low 32 bits in the logic.
Counts CountLogicPort::position(std::size_t axis, std::int32_t low) const noexcept {
  return Counts{unwrapped((input_.encoder[axis] - origin_[axis]).value(), low)} + origin_[axis];
}

std::optional<Counts> CountLogicPort::index(std::size_t axis) noexcept {
  const std::optional<std::int32_t> low = encoder_.index_position(axis);
  if (!low) return std::nullopt;
  return position(axis, *low);
}

void CountLogicPort::commit(const PerAxis<Pulses>& counts) noexcept {
  ++sequence_;
  pulse_train_.commit(counts, sequence_);
}

void CountLogicPort::clear_faults() noexcept {
  pulse_train_.clear_stops();
  pulse_train_.clear({.estop = true, .watchdog = true, .clipped = true, .recommit = true});
  encoder_.clear(kAllEncoderFlags);
  if (uncounted_axes_ != 0) read_uncounted_axes();  // an axis that counts continues to count
}

const PerAxis<Pulses>& CountLogicPort::emitted() noexcept {
  const PerAxis<std::int32_t> low = pulse_train_.emitted();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    emitted_[axis] = Pulses{unwrapped(emitted_[axis].value(), low[axis])};
  }
  return emitted_;
}

void CountLogicPort::read_residual() noexcept {
  const PerAxis<std::int32_t> low = pulse_train_.residual();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const Pulses residual{unwrapped(residual_[axis].value(), low[axis])};
    input_.not_emitted[axis] = residual - residual_[axis];
    residual_[axis] = residual;
  }
}

void CountLogicPort::read_uncounted_axes() noexcept {
  uncounted_axes_ = static_cast<std::uint8_t>(PulseTrain::kAllAxes & ~encoder_.known());
}

}  // namespace armature
