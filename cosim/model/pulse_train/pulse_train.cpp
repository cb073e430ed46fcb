#include "cosim/model/pulse_train/pulse_train.hpp"

#include <algorithm>
#include <stdexcept>

#include "controller/regs/pulse_train_regs.hpp"

namespace armature::cosim::model {
namespace train_regs = armature::regs::pulse_train;
namespace {

constexpr std::int32_t kMaxCount = 200;
constexpr std::uint32_t kEstopFault = train_regs::kFaultEstopMask, kWatchdogFault = train_regs::kFaultWatchdogMask,
                        kUnderrunFault = train_regs::kFaultUnderrunMask,
                        kResidualFault = train_regs::kFaultResidualMask, kClippedFault = train_regs::kFaultClippedMask,
                        kRecommitFault = train_regs::kFaultRecommitMask;

}  // namespace

StopControl::Inputs PulseTrain::stop_inputs(bool trigger) const {
  return {.pin_low = pins_.ago(2).estop,
          .stop = orders_.stop,
          .clear_estop = orders_.clear_estop,
          .clear_watchdog = orders_.clear_watchdog,
          .trigger = trigger,
          .run = run_,
          .pending = bank_.pending,
          .limit = limit_,
          .tick = times_.tick};
}

Answer PulseTrain::edge(Cycles at, const Strobes& access, const PulseInputs& in) {
  const StopControl::Inputs control = stop_inputs(in.trigger);
  const bool stopped = stop_.stops(control);
  Answer answer;
  if (gated_clock_stopped_) {
    run_axes(at, in.trigger, stopped);
    pins_.sample(arm_pins(in));
    find_wake(at, in);
    return answer;
  }
  if (is_settled_ && !stopped && at < axes_wake_at_ && !access.any() && !in.trigger &&
      pins_.are_settled(arm_pins(in))) {
    quiet_edge(at, control, in);
    return answer;
  }
  if (access.read) answer = read(at, word_offset(access.raddr));
  const std::uint8_t servo_pins = stop_.estop() || stop_.watchdog() ? std::uint8_t{0} : servo_on_;

  const std::uint32_t late_events = (clipped_ ? kClippedFault : 0u) | (residual_ ? kResidualFault : 0u);
  const bool recommit = orders_.commit && !stopped && bank_.pending && !in.trigger;
  clipped_ = residual_ = false;
  if (in.trigger) snapshot();
  run_axes(at, in.trigger, stopped);
  const StopControl::Events events = stop_.edge(at, control);
  move_bank(in.trigger, stopped);
  pins_.sample(arm_pins(in));
  orders_ = {};
  cleared_faults_ = 0;
  if (access.write) answer.werr = write(access);
  servo_pins_ = servo_pins;
  faults_.edge(at,
               late_events | (events.estop ? kEstopFault : 0u) | (events.watchdog ? kWatchdogFault : 0u) |
                   (events.underrun ? kUnderrunFault : 0u) | (recommit ? kRecommitFault : 0u),
               cleared_faults_);
  find_wake(at, in);
  return answer;
}

// An edge at which nothing is due but a commit and the end of an own tick.
void PulseTrain::quiet_edge(Cycles at, const StopControl::Inputs& control, const PulseInputs& in) {
  const bool commit = orders_.commit, recommit = commit && bank_.pending;
  const bool watchdog = stop_.edge(at, control).watchdog;
  if (commit) move_bank(false, false);
  orders_.commit = false;
  if (watchdog || recommit || clipped_) {
    faults_.edge(at, (watchdog ? kWatchdogFault : 0u) | (recommit ? kRecommitFault : 0u), 0);
    find_wake(at, in);
  } else {
    wakes_at_ = std::min(axes_wake_at_, stop_.wakes_at(at, control));
  }
}

Answer PulseTrain::access(Cycles at, const Strobes& access, const PulseInputs&) {
  Answer answer;
  if (access.read) answer = read(at, word_offset(access.raddr));
  if (!access.write) return answer;
  stop_.leave_out(at, times_.tick);
  cleared_faults_ = 0;
  answer.werr = write(access);
  const std::uint32_t offset = word_offset(access.waddr);
  if (element_at(offset, train_regs::kCountOffset)) return answer;  // which acts when it is committed
  faults_.edge(at, 0, cleared_faults_);
  is_settled_ = is_settled_ && offset == train_regs::kCommitOffset;
  wakes_at_ = at + Cycles{1};
  return answer;
}

void PulseTrain::run_axes(Cycles at, bool trigger, bool stopped) {
  if (!trigger && !stopped && at < axes_wake_at_) return;
  if (stopped && !generators_run_) throw std::logic_error{"model: a stop in a tick without edges"};
  for (std::size_t i = 0; i < kAxes; ++i) {
    PulseAxis& axis = axes_[i];
    axis.edge(at, times_, trigger, stopped);
    if (trigger) axis.begin_tick(at, times_, bank_.pending && !stopped ? bank_.counts[i] : 0, stopped);
  }
  show_axes();
}

void PulseTrain::show_axes() {
  step_ = dir_ = 0;
  for (std::size_t i = 0; i < kAxes; ++i) {
    step_ |= static_cast<std::uint8_t>(axes_[i].step() << i);
    dir_ |= static_cast<std::uint8_t>(axes_[i].positive() << i);
  }
}

// The trigger copies the counters of the tick that ends.
void PulseTrain::snapshot() {
  for (std::size_t i = 0; i < kAxes; ++i) {
    emitted_[i] = axes_[i].emitted();
    residuals_[i] += static_cast<std::uint32_t>(axes_[i].unfinished());
    residual_ = residual_ || axes_[i].unfinished() != 0;
  }
}

void PulseTrain::move_bank(bool trigger, bool stopped) {
  if (stopped) {
    bank_.pending = false;
  } else {
    if (trigger && bank_.pending) active_sequence_ = bank_.sequence;
    if (trigger || orders_.commit) bank_.pending = orders_.commit;
    if (orders_.commit) bank_.sequence = sequence_;
  }
  if (!orders_.commit) return;
  for (std::size_t i = 0; i < kAxes; ++i) {
    const std::int32_t count = static_cast<std::int16_t>(staged_[i]);
    bank_.counts[i] = std::clamp(count, -kMaxCount, kMaxCount);
    clipped_ = clipped_ || (bank_.counts[i] != count && !stopped);
  }
}

void PulseTrain::find_axes_wake(Cycles at) {
  axes_wake_at_ = kNever;
  if (!generators_run_) return;
  for (const PulseAxis& axis : axes_) axes_wake_at_ = std::min(axes_wake_at_, axis.wakes_at(times_));
  axes_wake_at_ = std::max(axes_wake_at_, at + Cycles{1});  // a hold time that was made shorter may be over already
}

void PulseTrain::find_wake(Cycles at, const PulseInputs& in) {
  const StopControl::Inputs control = stop_inputs(false);
  const bool stops = stop_.stops(control);
  find_axes_wake(at);
  const auto runs = [](const PulseAxis& axis) { return axis.is_running(); };
  const bool free_due = !pins_.are_settled(arm_pins(in)) || (stops && std::ranges::any_of(axes_, runs));
  if (gated_clock_stopped_) {
    wakes_at_ = free_due ? at + Cycles{1} : axes_wake_at_;
    return;
  }
  const bool locked_out = stop_.estop() || stop_.watchdog();
  const bool due = free_due || orders_.stops_or_clears() || clipped_ || residual_ || (stops && bank_.pending) ||
                   servo_pins_ != (locked_out ? 0 : servo_on_);
  is_settled_ = !due;
  wakes_at_ = due || orders_.commit ? at + Cycles{1} : std::min(axes_wake_at_, stop_.wakes_at(at, control));
}

std::optional<TickPulses> PulseTrain::whole_tick(Cycles at) const {
  if (gated_clock_stopped_ || !stop_.is_calm(stop_inputs(false)) || orders_.stop) return std::nullopt;
  std::optional<TickPulses> tick{TickPulses{.begins = at, .ends = at + times_.tick}};
  for (std::size_t i = 0; i < kAxes; ++i) {
    const std::optional<AxisPulses> pulses = axes_[i].whole_tick(times_);
    if (!pulses) {
      tick.reset();
      break;
    }
    tick->axes[i] = *pulses;
  }
  return tick;
}

void PulseTrain::finish_tick(const TickPulses& pulses) {
  for (std::size_t i = 0; i < kAxes; ++i) axes_[i].finish_tick(pulses.axes[i]);
}

void PulseTrain::leave_out_generators(Cycles at) {
  generators_run_ = false;
  axes_wake_at_ = kNever;
  wakes_at_ = at + Cycles{1};
}

void PulseTrain::run_generators(Cycles at) {
  generators_run_ = true;
  show_axes();
  find_axes_wake(at);
}

void PulseTrain::generator_edge(Cycles at) {
  run_axes(at, false, false);
  find_axes_wake(at);
}

bool PulseTrain::write_disturbs(std::uint32_t offset) {
  return !element_at(offset, train_regs::kCountOffset) && offset != train_regs::kCommitOffset &&
         offset != train_regs::kFaultOffset && offset != train_regs::kKeyOffset;
}

Answer PulseTrain::read(Cycles at, std::uint32_t offset) const {
  if (const auto i = element_at(offset, train_regs::kCountOffset)) return {.rdata = staged_[*i]};
  if (const auto i = element_at(offset, train_regs::kEmittedOffset)) return {.rdata = emitted_[*i]};
  if (const auto i = element_at(offset, train_regs::kResidualOffset)) return {.rdata = residuals_[*i]};
  if (const auto i = element_at(offset, train_regs::kFaultTimeOffset)) return {.rdata = faults_.time(*i)};
  const ArmPins& pins = pins_.ago(2);
  const auto word = [](auto... fields) { return Answer{.rdata = (0u | ... | fields)}; };
  using armature::regs::insert;
  switch (offset) {
    case train_regs::kIdOffset:
      return word(train_regs::kIdWord);
    case train_regs::kCtrlOffset:
      return word(insert(0, train_regs::kCtrlServoOn, servo_on_), insert(0, train_regs::kCtrlRun, run_));
    case train_regs::kStatusOffset:
      return word(
          insert(0, train_regs::kStatusEstop, stop_.estop()), insert(0, train_regs::kStatusWatchdog, stop_.watchdog()),
          insert(0, train_regs::kStatusEstopPin, pins.estop), insert(0, train_regs::kStatusPending, bank_.pending),
          insert(0, train_regs::kStatusSequence, active_sequence_));
    case train_regs::kEstopOffset:
      return word(0u);
    case train_regs::kFaultOffset:
      return word(faults_.flags());
    case train_regs::kWatchdogOffset:
      return word(insert(0, train_regs::kWatchdogLimit, limit_),
                  insert(0, train_regs::kWatchdogInARow, stop_.in_a_row()),
                  insert(0, train_regs::kWatchdogIdleTicks, stop_.idle_ticks()));
    case train_regs::kUnderrunsOffset:
      return word(stop_.underruns());
    case train_regs::kTickCyclesOffset:
      return word(static_cast<std::uint32_t>(times_.tick.value()));
    case train_regs::kDirSetupOffset:
      return word(static_cast<std::uint32_t>(times_.dir_setup.value()));
    case train_regs::kDirHoldOffset:
      return word(static_cast<std::uint32_t>(times_.dir_hold.value()));
    case train_regs::kCommitOffset:
      return word(std::uint32_t{sequence_});
    case train_regs::kTimeOffset:
      return word(static_cast<std::uint32_t>(at.value() - 1));
    case train_regs::kSwitchesOffset:
      return word(insert(0, train_regs::kSwitchesHome, pins.home),
                  insert(0, train_regs::kSwitchesLimitPos, pins.limit_pos),
                  insert(0, train_regs::kSwitchesLimitNeg, pins.limit_neg));
    case train_regs::kDrivesOffset:
      return word(insert(0, train_regs::kDrivesAlarm, pins.drive_alarm),
                  insert(0, train_regs::kDrivesInPosition, pins.in_position),
                  insert(0, train_regs::kDrivesServoOn, servo_pins_));
    case train_regs::kKeyOffset:
      return word(std::uint32_t{unlocked_});
    default:
      return kUnmappedRead;
  }
}

bool PulseTrain::write(const Strobes& access) {
  const std::uint32_t offset = word_offset(access.waddr);
  const bool locked = servo_pins_ != 0 && !unlocked_;
  if (const auto axis = element_at(offset, train_regs::kCountOffset)) {
    std::uint16_t& staged = staged_[*axis];
    staged = static_cast<std::uint16_t>(merged(staged, access));
    return false;
  }
  const std::uint32_t ones = merged(0, access);  // bits that are written as 1
  switch (offset) {
    case train_regs::kCtrlOffset:
      return write_ctrl(access, locked);
    case train_regs::kEstopOffset:
      orders_.stop = (ones & train_regs::kEstopStopMask) != 0;
      orders_.clear_estop = (ones & train_regs::kEstopClearEstopMask) != 0;
      orders_.clear_watchdog = (ones & train_regs::kEstopClearWatchdogMask) != 0;
      return false;
    case train_regs::kFaultOffset:
      cleared_faults_ = ones;
      return false;
    case train_regs::kCommitOffset:
      sequence_ = static_cast<std::uint16_t>(merged(sequence_, access));
      orders_.commit = access.wstrb != 0;
      return false;
    case train_regs::kKeyOffset:
      unlocked_ = access.wstrb == 0xF && access.wdata == train_regs::kKeyWord;
      return false;
    default:
      return write_protected(access, locked);
  }
}

// While locked, CTRL.run can be set but not cleared.
bool PulseTrain::write_ctrl(const Strobes& access, bool locked) {
  using armature::regs::extract;
  const std::uint32_t old = armature::regs::insert(servo_on_, train_regs::kCtrlRun, run_);
  const std::uint32_t word = merged(old, access);
  servo_on_ = static_cast<std::uint8_t>(extract(word, train_regs::kCtrlServoOn));
  const bool run = extract(word, train_regs::kCtrlRun) != 0;
  const bool refused = locked && run_ && !run;
  run_ = run || refused;
  return refused;
}

bool PulseTrain::write_protected(const Strobes& access, bool locked) {
  using armature::regs::extract;
  const auto put = [&](Cycles& value, armature::regs::Field field) {
    value = Cycles{extract(merged(static_cast<std::uint32_t>(value.value()), access), field)};
  };
  switch (word_offset(access.waddr)) {
    case train_regs::kWatchdogOffset:
      if (!locked) limit_ = extract(merged(limit_, access), train_regs::kWatchdogLimit);
      return locked;
    case train_regs::kTickCyclesOffset:
      if (!locked) put(times_.tick, train_regs::kTickCyclesValue);
      return locked;
    case train_regs::kDirSetupOffset:
      if (!locked) put(times_.dir_setup, train_regs::kDirSetupValue);
      return locked;
    case train_regs::kDirHoldOffset:
      if (!locked) put(times_.dir_hold, train_regs::kDirHoldValue);
      return locked;
    default:
      return true;
  }
}

}  // namespace armature::cosim::model
