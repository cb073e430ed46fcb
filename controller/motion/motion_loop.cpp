#include "controller/motion/motion_loop.hpp"

#include <bit>
#include <cassert>
#include <optional>
#include <utility>

#include "controller/base/timebase.hpp"
#include "controller/drivers/axi_gpio.hpp"

namespace armature {
namespace {

// All axes must have stood still, within a count, for this time before Fault can be left: 5 ms.
constexpr Ticks kStandstill{100};

std::uint8_t first_axis(std::uint8_t mask) {
  return static_cast<std::uint8_t>(std::countr_zero(mask) + 1);
}

}  // namespace

MotionLoop::MotionLoop(const RobotModel& robot, bool feedback, LogicPort& logic, RegisterBus& bus, LoopChannel& channel,
                       SetPointSource& source, ControllerObserver& observer, bool referenced,
                       InverseCheck* inverse) noexcept
    : robot_{robot},
      bus_{bus},
      channel_{channel},
      observer_{observer},
      logic_{logic},
      axes_{make_per_axis([&](std::size_t axis) {
        return AxisControl{robot.axes[axis], feedback};
      })},
      source_{source},
      inverse_{inverse},
      referenced_{referenced ? PulseTrain::kAllAxes : std::uint8_t{0}},
      monitor_{robot},
      watch_{channel} {}

void MotionLoop::run() noexcept {
  start();
  Cycles waits_since = bus_.now();
  time_.start(waits_since);
  for (; bus_.wait_for_interrupt(Interrupts::kTimer) != Interrupts::kNone; waits_since = bus_.now()) {
    time_.wake(waits_since, bus_.now());
    bus_.charge(Work::kInterruptEntry);
    logic_.acknowledge();
    tick();
  }
}

void MotionLoop::start() noexcept {
  if (!logic_.identified() || (inverse_ != nullptr && !inverse_->usable)) {
    // The trigger is never started, so the core sleeps for good.
    telemetry_.state = MotionState::kFault;
    telemetry_.fault = FaultCause::kHardwareId;
    report_fault();
    answer(Answer::Kind::kUnusable);
    return;
  }
  logic_.start(robot_);
  AxiGpio{bus_}.drive_outputs();
  emission_.committed({}, logic_.sequence());
  const LogicInput& input = logic_.sample();
  restart_axes();
  if (logic_.uncounted_axes() != 0) {
    enter_fault({FaultCause::kEncoder, first_axis(logic_.uncounted_axes())});
  } else if (!logic_.drives_at_start()) {
    enter_fault({FaultCause::kDrivesOff});
  } else {
    answer(Answer::Kind::kRest);
    return;
  }
  update_telemetry(input);
  report_fault();
}

void MotionLoop::tick() noexcept {
  telemetry_.tick += Ticks{1};
  const LogicInput& input = logic_.sample();
  for (std::size_t axis = 0; axis < kAxes; ++axis) telemetry_.actual[axis] = axes_[axis].actual(input.encoder[axis]);
  watch_.observe(telemetry_.tick, bus_);
  // The logic counts the ticks that a late core misses. That of Vo 2021 does not.
  const bool counts_ticks = input.always_counted == PulseTrain::kAllAxes;
  time_.observe(counts_ticks ? std::optional{input.new_underruns} : std::nullopt);
  const bool was_in_fault = telemetry_.state == MotionState::kFault;
  const FaultCause cause_before = telemetry_.fault;
  if (was_in_fault) {
    tick_in_fault(input);
  } else {
    account_for_emission(input);
    if (input.new_underruns == 0) {
      monitor_.observe(input.encoder);
    } else {  // more than a tick since the last one
      monitor_.restart();
    }
    if (const Finding finding = find_fault(input); finding.cause != FaultCause::kNone) {
      enter_fault(finding);
    } else if (source_.take_order() == SetPointSource::Order::kSwitchOff) {
      enter_fault({FaultCause::kDrivesOff});
    } else if (!emission_.is_waiting()) {
      follow_source(input);
    }
  }
  update_telemetry(input);
  observer_.on_tick(telemetry_);
  const bool in_fault = telemetry_.state == MotionState::kFault;
  if (in_fault && telemetry_.fault != cause_before) report_fault();
  if (was_in_fault && !in_fault) observer_.on_event(FaultCleared{.tick = telemetry_.tick});
}

void MotionLoop::account_for_emission(const LogicInput& input) noexcept {
  emission_.observe(input.status.sequence, input.status.pending, input.new_underruns,
                    [&](const PerAxis<Pulses>& counts) {
                      for (std::size_t axis = 0; axis < kAxes; ++axis) axes_[axis].tick_emitted(counts[axis]);
                    });
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (input.not_emitted[axis] != Pulses{0}) axes_[axis].not_emitted(input.not_emitted[axis]);
  }
  // A stopped logic discards sets, too: the fault that follows reads what was emitted.
  if (emission_.uncertain() && !input.status.estop && !input.status.watchdog) [[unlikely]] {
    const PerAxis<Pulses>& emitted = logic_.emitted();
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      axes_[axis].set_emitted(emitted[axis], emission_.active()[axis]);
    }
  }
}

MotionLoop::Finding MotionLoop::find_fault(const LogicInput& input) const noexcept {
  if (input.status.estop) return {FaultCause::kEstop};
  if (input.status.watchdog) return {FaultCause::kWatchdog};
  if (const auto off = static_cast<std::uint8_t>(PulseTrain::kAllAxes & ~input.drives.servo_on); off != 0) {
    return {FaultCause::kServoEnable, off == PulseTrain::kAllAxes ? std::uint8_t{0} : first_axis(off)};
  }
  if (time_.stood_still() || time_.wrong()) return {FaultCause::kClock};
  if (watch_.silent()) return {FaultCause::kCore1Silent};
  if (watch_.code_changed()) return {FaultCause::kCodeChanged};
  if (inverse_ != nullptr && inverse_->differs) return {FaultCause::kInverseKinematics, inverse_->differing_axis};
  if (input.drives.alarm != 0) return {FaultCause::kDriveAlarm, first_axis(input.drives.alarm)};
  if (input.encoder_faults.any()) {
    return {FaultCause::kEncoder, first_axis(input.encoder_faults.illegal | input.encoder_faults.index)};
  }
  return find_axis_fault(input);
}

MotionLoop::Finding MotionLoop::find_axis_fault(const LogicInput& input) const noexcept {
  const unsigned obeyed = ~unsigned{source_.last().homing};
  const unsigned limit_pos = input.switches.limit_pos & obeyed, limit_neg = input.switches.limit_neg & obeyed;
  for (std::uint8_t axis = 0; axis < kAxes; ++axis) {
    const AxisControl& control = axes_[axis];
    const auto number = static_cast<std::uint8_t>(axis + 1);
    // An axis may move away from an active limit switch.
    const unsigned blocked = control.direction() > 0 ? limit_pos : control.direction() < 0 ? limit_neg : 0u;
    if (((blocked >> axis) & 1u) != 0) return {FaultCause::kLimitSwitch, number};
    const bool always_counted = ((input.always_counted >> axis) & 1u) != 0;
    if (always_counted && control.following_error(telemetry_.actual[axis]))
      return {FaultCause::kFollowingError, number};
  }
  if (deviating_axis_ != 0 && ((input.always_counted >> (deviating_axis_ - 1)) & 1u) != 0) {
    return {FaultCause::kFollowingError, deviating_axis_};
  }
  if (const auto axes = static_cast<std::uint8_t>(monitor_.too_fast() & input.always_counted); axes != 0) {
    return {FaultCause::kEncoderSpeed, first_axis(axes)};
  }
  if (const auto axes = static_cast<std::uint8_t>(monitor_.too_hard() & input.always_counted); axes != 0) {
    return {FaultCause::kEncoderAccel, first_axis(axes)};
  }
  return {};
}

// Those whose decoder may have lost counts. While the logic stood still, it has not counted.
std::uint8_t MotionLoop::uncounted_motion(const LogicInput& input) const noexcept {
  const unsigned flags = input.encoder_faults.illegal | input.encoder_faults.index;
  return static_cast<std::uint8_t>((time_.stood_still() ? PulseTrain::kAllAxes : flags) & input.always_counted);
}

// Those whose encoder may be false.
std::uint8_t MotionLoop::untrusted_axes(const LogicInput& input) const noexcept {
  unsigned axes = uncounted_motion(input) | monitor_.too_fast() | monitor_.too_hard();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const AxisControl& control = axes_[axis];
    if (control.deviates() || control.following_error(telemetry_.actual[axis])) axes |= 1u << axis;
  }
  return static_cast<std::uint8_t>(axes & input.always_counted);
}

void MotionLoop::follow_source(const LogicInput& input) noexcept {
  if (const PinLevels pins = source_.last().pins; pins.mask != 0) AxiGpio{bus_}.set_levels(pins.mask, pins.levels);
  const SetPoint& computed = source_.advance(telemetry_.tick);
  telemetry_.state = computed.state;
  referenced_ = static_cast<std::uint8_t>(referenced_ & ~computed.homing);
  if (computed.wake) bus_.send_event();
  const bool stopped = computed.stopped;
  if (computed.located != 0) shift_positions(computed);
  if (stopped) answer(Answer::Kind::kRest);

  const SetPoint& next = source_.last();  // another one after a shift
  PerAxis<Pulses> counts{};
  for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) {
    counts[axis] = axes_[axis].next(next.position[axis], input.encoder[axis]);
  }
  if (monitor_.rests()) judge_deviation(input);
  bus_.charge(Work::kTick);
  if (next.planned) bus_.charge(Work::kRetarget);
  const std::int64_t charged = inverse_ != nullptr ? std::exchange(inverse_->charged, 0) : 0;
  if (next.inverses > charged) bus_.charge(Work::kInverse, next.inverses - charged);
  logic_.commit(counts);
  emission_.committed(counts, logic_.sequence());
}

// Of one axis, the next one.
void MotionLoop::judge_deviation(const LogicInput& input) noexcept {
  deviating_axis_ = axes_[judged_].judge_deviation(input.encoder[judged_]) ? static_cast<std::uint8_t>(judged_ + 1) : 0;
  judged_ = judged_ + 1 < kAxes ? judged_ + 1 : 0;
}

// All axes stand: they do so at other positions than before, and everything that they have sent is emitted.
void MotionLoop::shift_positions(const SetPoint& located) noexcept {
  const std::uint8_t axes = located.located;
  for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) {
    if (((axes >> axis) & 1u) == 0) continue;
    logic_.shift_position(axis, located.shift[axis]);
    const Counts encoder = logic_.last().encoder[axis];
    axes_[axis].restart(axes_[axis].committed(), encoder);
    telemetry_.actual[axis] = axes_[axis].actual(encoder);
  }
  monitor_.restart();
  referenced_ = static_cast<std::uint8_t>(referenced_ | axes);
  reset_source();
}

void MotionLoop::enter_fault(const Finding& finding) noexcept {
  logic_.commit({});
  logic_.set_servo(false);
  telemetry_.state = MotionState::kFault;
  telemetry_.fault = finding.cause;
  telemetry_.fault_axis = finding.axis;
  referenced_ = static_cast<std::uint8_t>(referenced_ & ~untrusted_axes(logic_.last()));
  clearing_ = false;
  still_ = Ticks{0};
  source_.cut_short(telemetry_.tick);
  answer(Answer::Kind::kFault);
}

void MotionLoop::tick_in_fault(const LogicInput& input) noexcept {
  if (input.drives.servo_on != 0) logic_.set_servo(false);  // something else has enabled a drive
  update_standstill(input.encoder);
  referenced_ = static_cast<std::uint8_t>(referenced_ & ~uncounted_motion(input));
  // Only the logic knows how many of the pulses committed before the fault were emitted.
  const PerAxis<Pulses>& emitted = logic_.emitted();
  for (std::size_t axis = 0; axis < kAxes; ++axis) axes_[axis].set_committed(emitted[axis]);
  bool ended = false;
  if (clearing_) {
    clearing_ = false;
    ended = fault_can_end(input);
    if (!ended) answer(Answer::Kind::kFaultPersists);
  } else if (source_.take_order() == SetPointSource::Order::kClearFault) {
    logic_.clear_faults();
    if (inverse_ != nullptr) inverse_->differs = false;
    clearing_ = true;
  }
  source_.cancel(telemetry_.tick);
  if (watch_.code_changed()) [[unlikely]] {
    // Whatever this core commits may be wrong. Without a commit the watchdog of the logic holds the stop.
    telemetry_.fault = FaultCause::kCodeChanged;
    telemetry_.fault_axis = 0;
  } else {
    logic_.commit({});
  }
  if (channel_.wake_each_tick.load(std::memory_order_relaxed)) bus_.send_event();
  if (!ended) return;
  logic_.set_servo(true);
  emission_.reset();
  emission_.committed({}, logic_.sequence());
  restart_axes();
  telemetry_.state = MotionState::kIdle;
  telemetry_.fault = FaultCause::kNone;
  telemetry_.fault_axis = 0;
  answer(Answer::Kind::kRest);
}

bool MotionLoop::fault_can_end(const LogicInput& input) const noexcept {
  const bool stopped = input.status.estop || input.status.estop_pin || input.status.watchdog;
  return !stopped && !time_.wrong() && !watch_.code_changed() && input.drives.alarm == 0 &&
         !input.encoder_faults.any() && logic_.uncounted_axes() == 0 && still_ >= kStandstill;
}

void MotionLoop::update_standstill(const PerAxis<Counts>& encoder) noexcept {
  still_ += Ticks{1};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const Counts moved = encoder[axis] - still_position_[axis];
    if (moved >= Counts{-1} && moved <= Counts{1}) continue;
    still_position_ = encoder;
    still_ = Ticks{0};
    return;
  }
}

void MotionLoop::restart_axes() noexcept {
  const PerAxis<Pulses>& emitted = logic_.emitted();
  for (std::size_t axis = 0; axis < kAxes; ++axis)
    axes_[axis].restart(emitted[axis], standstill_position(axis, emitted[axis]));
  monitor_.restart();
  deviating_axis_ = 0;
  reset_source();
}

void MotionLoop::reset_source() noexcept {
  source_.reset_to(
      make_per_axis([&](std::size_t axis) { return axis < robot_.axis_count ? axes_[axis].reference() : Radians{}; }));
}

// If the encoder of an axis is not always counted, its position follows from its pulses, provided its drive executed
// all of them.
Counts MotionLoop::standstill_position(std::size_t axis, Pulses emitted) const noexcept {
  const LogicInput& input = logic_.last();
  if (((input.always_counted >> axis) & 1u) != 0) return input.encoder[axis];
  return axes_[axis].counts_of(emitted);
}

void MotionLoop::answer(Answer::Kind kind) noexcept {
  [[maybe_unused]] const bool pushed = channel_.answers.try_push(
      {.kind = kind, .position = source_.last().position, .number = channel_.number, .referenced = referenced_});
  assert(pushed);  // never full, see Channel
  bus_.send_event();
}

void MotionLoop::report_fault() noexcept {
  observer_.on_event(Faulted{.cause = telemetry_.fault, .axis = telemetry_.fault_axis, .tick = telemetry_.tick});
}

void MotionLoop::update_telemetry(const LogicInput& input) noexcept {
  telemetry_.sequence = logic_.sequence();
  telemetry_.referenced = referenced_;
  telemetry_.underruns = input.underruns;
  telemetry_.rate = telemetry_.state == MotionState::kFault ? 0.0 : source_.last().rate;
  telemetry_.encoder = input.encoder;
  if (inverse_ != nullptr) {
    telemetry_.solved_poses = inverse_->solved;
    telemetry_.solver_difference_pulses = inverse_->difference_pulses;
  }
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const AxisControl& control = axes_[axis];
    telemetry_.reference[axis] = control.reference();
    telemetry_.reference_pulses[axis] = control.reference_pulses();
    telemetry_.correction[axis] = control.correction();
    telemetry_.commanded[axis] = control.committed();
    channel_.position.set(axis, telemetry_.reference[axis], telemetry_.actual[axis]);
  }
}

}  // namespace armature
