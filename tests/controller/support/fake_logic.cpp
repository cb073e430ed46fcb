#include "tests/controller/support/fake_logic.hpp"

#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <stdexcept>
#include <utility>

#include "controller/regs/axi_timer_regs.hpp"
#include "controller/regs/pulse_width_regs.hpp"

namespace armature::test {
namespace {

namespace pt = regs::pulse_train;
namespace pw = regs::pulse_width;
namespace en = regs::encoder;
namespace sw = regs::encoder_switch;
namespace tm = regs::axi_timer;
namespace io = regs::axi_gpio;

constexpr RegAddr kTimer{regs::soc::kAxiTimerBase};
constexpr RegAddr kStatus = FakeLogic::kPulses + pt::kStatusOffset, kFault = FakeLogic::kPulses + pt::kFaultOffset;
constexpr std::int64_t kTick = FakeLogic::kTick;
constexpr std::int64_t kLargestCount = 200;  // of a tick; more is clipped
constexpr std::int64_t kDirTime = 25;        // cycles

constexpr RegAddr element(RegAddr block, std::uint32_t offset, std::size_t axis) {
  return block + (offset + 4 * static_cast<std::uint32_t>(axis));
}

[[noreturn]] void refuse(const char* what, std::uint32_t value) {
  throw std::logic_error{std::string{what} + " " + std::to_string(value)};
}

// The edges of step in a tick with that half period, in cycles.
std::int64_t toggles(std::int64_t width) {
  return width == 0 ? 0 : (kTick - 1) / std::abs(width);
}

}  // namespace

FakeLogic::FakeLogic(Variant variant, std::int64_t sub_steps)
    : paper_{variant == Variant::kPaper}, step_cycles_{kTick / sub_steps} {
  const auto use = [this](Kind kind, RegAddr block, std::initializer_list<std::uint32_t> offsets,
                          std::size_t count = 1) {
    for (const std::uint32_t offset : offsets) {
      for (std::size_t i = 0; i < count; ++i) kinds_[index(element(block, offset, i))] = kind;
    }
  };
  use(Kind::kMemory, kTimer, {tm::kTlr0Offset});
  use(Kind::kActive, kTimer, {tm::kTcsr0Offset});
  use(Kind::kMemory, kTool, {io::kTriOffset, io::kData2Offset, io::kGierOffset, io::kIerOffset});
  use(Kind::kActive, kTool, {io::kDataOffset, io::kIsrOffset});
  word(kTool + io::kTriOffset) = io::kTriValueReset;
  use(Kind::kMemory, kPulses, {pt::kIdOffset, pt::kCtrlOffset, pt::kSwitchesOffset, pt::kDrivesOffset});
  use(Kind::kActive, kPulses, {pt::kStatusOffset, pt::kEstopOffset, pt::kFaultOffset});
  use(Kind::kMemory, kPulses, {pt::kEmittedOffset}, kAxes);
  use(Kind::kMemory, kEncoder, {en::kIdOffset, en::kKnownOffset, en::kPositionOffset});
  use(Kind::kActive, kEncoder, {en::kFaultOffset});
  if (paper_) {
    use(Kind::kTime, kPulses, {pw::kTimeOffset});
    use(Kind::kActive, kPulses, {pw::kWidthOffset}, kAxes);
    use(Kind::kMemory, kEncoder, {en::kTriggerTimeOffset});
    use(Kind::kMemory, kSwitch, {sw::kIdOffset});
    use(Kind::kActive, kSwitch, {sw::kSelectOffset});
    pulses_id = pw::kIdWord;
    encoder_id = regs::insert(en::kIdWord, en::kIdAxes, 1);
    switch_id = sw::kIdWord;
    encoder_known = 1;
  } else {
    use(Kind::kMemory, kPulses, {pt::kUnderrunsOffset});
    use(Kind::kActive, kPulses, {pt::kTickCyclesOffset, pt::kDirSetupOffset, pt::kDirHoldOffset, pt::kWatchdogOffset});
    use(Kind::kActive, kPulses, {pt::kCommitOffset});
    use(Kind::kMemory, kPulses, {pt::kCountOffset, pt::kResidualOffset}, kAxes);
    use(Kind::kMemory, kEncoder, {en::kIndexCheckOffset, en::kIndexSeenOffset});
    use(Kind::kMemory, kEncoder, {en::kPositionOffset, en::kCountsPerRevOffset, en::kIndexPositionOffset}, kAxes);
    pulses_id = pt::kIdWord;
    encoder_id = en::kIdWord;
    encoder_known = en::kKnownAxesMask;
    word(kPulses + pt::kWatchdogOffset) = pt::kWatchdogLimitReset;
    word(kPulses + pt::kDirSetupOffset) = pt::kDirSetupValueReset;
    word(kPulses + pt::kDirHoldOffset) = pt::kDirHoldValueReset;
  }
}

void FakeLogic::fit_drives(const RobotModel& robot) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const AxisModel& from = robot.axes[axis];
    drives[axis].natural_rad_s = from.drive_natural_rad_s;
    drives[axis].damping = from.drive_damping;
    drives[axis].counts_per_pulse = static_cast<double>(from.counts_per_rev) / from.pulses_per_rev;
  }
}

void FakeLogic::set_tool_input(int pin, bool level) {
  std::uint32_t& levels = word(kTool + io::kData2Offset);
  const std::uint32_t before = levels;
  levels = regs::insert(levels, {.lsb = static_cast<std::uint32_t>(pin - 1), .width = 1}, level ? 1 : 0);
  if (levels != before) word(kTool + io::kIsrOffset) |= io::kIsrChannel2Mask;
}

bool FakeLogic::tool_interrupts() const {
  return (word(kTool + io::kGierOffset) & io::kGierEnableMask) != 0 &&
         (word(kTool + io::kIsrOffset) & word(kTool + io::kIerOffset)) != 0;
}
std::int64_t FakeLogic::width(std::size_t axis) const {
  return static_cast<std::int32_t>(word(element(kPulses, pw::kWidthOffset, axis)));
}
std::uint32_t FakeLogic::servo_on() const {
  return stopped() ? 0 : word(kPulses + pt::kCtrlOffset) & pt::kCtrlServoOnMask;
}
bool FakeLogic::stopped() const {
  return (word(kStatus) & (pt::kStatusEstopMask | pt::kStatusWatchdogMask)) != 0;
}

Interrupts FakeLogic::wait_for_interrupt(Interrupts) noexcept {
  on_wait();
  if (tick_start_ < 0) return Interrupts::kNone;  // would sleep for ever
  while (!interrupt_ && triggers_ < triggers_to_run) pass(cycles_to_trigger());
  return triggers_ < triggers_to_run ? Interrupts::kTimer : Interrupts::kNone;
}

void FakeLogic::charge(Work work, std::int64_t times) noexcept {
  pass((work == Work::kTick ? tick_cycles : work_cycles) * times);
}

void FakeLogic::pass(std::int64_t cycles) {
  if (cycles == 0) return;
  const std::int64_t end = now_ + cycles;
  while (tick_start_ >= 0) {
    const std::int64_t number = (now_ - tick_start_) / step_cycles_ + 1;
    const std::int64_t next = tick_start_ + number * step_cycles_;
    if (next > end) break;
    now_ = next;
    sub_step(number);
    if (now_ - tick_start_ == kTick) trigger();
  }
  now_ = end;
}

void FakeLogic::latch(std::uint32_t stop) {
  static_assert(pt::kStatusEstopMask == pt::kFaultEstopMask && pt::kStatusWatchdogMask == pt::kFaultWatchdogMask);
  static_assert(pt::kStatusEstopMask == pw::kStatusEstopMask && pt::kFaultEstopMask == pw::kFaultEstopMask);
  if ((word(kStatus) & stop) != 0) return;
  word(kStatus) |= stop;
  word(kFault) |= stop;
  if (!paper_) return;
  active_ = {};
  word(kStatus) &= ~pw::kStatusArmedMask;
}

// The pulses that are due by the end of the step, then the drives.
void FakeLogic::sub_step(std::int64_t number) {
  word(kStatus) = regs::insert(word(kStatus), pt::kStatusEstopPin, estop_pin ? 1 : 0);
  if (estop_pin) latch(pt::kStatusEstopMask);
  const std::int64_t sub_steps = kTick / step_cycles_;
  const double h = static_cast<double>(step_cycles_) / regs::soc::kClkFreqHz;
  const std::uint32_t servo = servo_on() & ~alarm;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    drives[axis].enable(((servo >> axis) & 1u) != 0);
    const std::int64_t size = std::abs(active_[axis]) - cut_[axis];
    const std::int64_t direction = active_[axis] < 0 ? -1 : 1;
    const std::int64_t due = (2 * number * size + sub_steps) / (2 * sub_steps);
    for (; !stopped() && in_tick_[axis] < due; ++in_tick_[axis]) {
      emitted_[axis] += direction;
      drives[axis].step(direction);
    }
    drives[axis].move(h);
  }
}

void FakeLogic::trigger() {
  tick_start_ = now_;
  interrupt_ = true;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::int64_t missing = std::abs(active_[axis]) - in_tick_[axis];
    if (missing != 0) word(kFault) |= pt::kFaultResidualMask;
    word(element(kPulses, pt::kResidualOffset, axis)) +=
        static_cast<std::uint32_t>(active_[axis] < 0 ? -missing : missing);
    word(element(kPulses, pt::kEmittedOffset, axis)) = static_cast<std::uint32_t>(emitted_[axis]);
  }
  show_positions();
  word(kEncoder + en::kTriggerTimeOffset) = static_cast<std::uint32_t>(now_);
  word(kEncoder + en::kFaultOffset) |= std::exchange(encoder_fault, 0);
  in_tick_ = cut_ = {};
  if (paper_) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) start_width(axis);
  } else {
    start_counts();
  }
  const std::int64_t number = triggers_++;
  if (on_trigger) on_trigger(number);
}

void FakeLogic::show_positions() {
  for (std::size_t axis = 0; axis < (paper_ ? 1 : kAxes); ++axis) {
    const std::int64_t counts = paper_ ? decoded_ + count(selected) : count(axis);
    word(element(kEncoder, en::kPositionOffset, axis)) = static_cast<std::uint32_t>(counts);
  }
}

void FakeLogic::start_counts() {
  const bool committed = (word(kStatus) & pt::kStatusPendingMask) != 0;
  active_ = {};
  word(kStatus) &= ~pt::kStatusPendingMask;
  if (stopped() || committed) in_a_row_ = 0;
  if (stopped()) return;  // discards a commit and expects none
  if (committed) {
    active_ = pending_;
    word(kStatus) = regs::insert(word(kStatus), pt::kStatusSequence, word(kPulses + pt::kCommitOffset));
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      largest_count_ = std::max(largest_count_, std::abs(active_[axis]));
      cut_[axis] = std::min(shorten[axis], std::abs(active_[axis]));
      shorten[axis] -= cut_[axis];
    }
  } else if ((word(kPulses + pt::kCtrlOffset) & pt::kCtrlRunMask) != 0) {
    ++word(kPulses + pt::kUnderrunsOffset);
    word(kFault) |= pt::kFaultUnderrunMask;
    if (++in_a_row_ >= word(kPulses + pt::kWatchdogOffset)) latch(pt::kStatusWatchdogMask);
  }
}

void FakeLogic::start_width(std::size_t axis) {
  const bool armed = ((regs::extract(word(kStatus), pw::kStatusArmed) >> axis) & 1u) != 0;
  const std::int64_t next = armed ? width(axis) : 0;
  const std::int64_t before = std::exchange(widths_[axis], next);
  active_[axis] = (toggles(next) + 1) / 2 * (next < 0 ? -1 : 1);
  if (next == 0 || (next > 0) == forward_[axis]) return;
  forward_[axis] = next > 0;
  const bool set_up = std::abs(next) >= kDirTime;
  const bool low = toggles(before) % 2 == 0;
  const bool held = before == 0 || kTick - toggles(before) * std::abs(before) >= kDirTime;
  if (set_up && low && held) return;
  breaches.push_back("axis " + std::to_string(axis + 1) + " turns at trigger " + std::to_string(triggers_) + ": " +
                     (!set_up ? "set-up too short"
                      : !low  ? "step is high"
                              : "hold too short"));
}

std::uint32_t FakeLogic::read(RegAddr addr) const {
  const Kind kind = kinds_[index(addr)];
  if (kind == Kind::kUnused) refuse("read of register", addr.value);
  return kind == Kind::kTime ? static_cast<std::uint32_t>(now_) : word(addr);
}

void FakeLogic::write(RegAddr addr, std::uint32_t value) {
  if (kinds_[index(addr)] < Kind::kActive) refuse("write of register", addr.value);
  std::uint32_t& target = word(addr);
  switch (addr.value) {
    case (kTimer + tm::kTcsr0Offset).value:
      if ((value & tm::kTcsr0TintMask) != 0) interrupt_ = false;
      if ((value & tm::kTcsr0EntMask) == 0 || tick_start_ >= 0) return;
      if (word(kTimer + tm::kTlr0Offset) + 2 != kTick) refuse("load", word(kTimer + tm::kTlr0Offset));
      tick_start_ = now_;
      show_positions();  // as left by the last trigger before a restart of the software
      return;
    case (kPulses + pt::kEstopOffset).value:
      if ((value & pt::kEstopStopMask) != 0) latch(pt::kStatusEstopMask);
      if ((value & pt::kEstopClearEstopMask) != 0 && !estop_pin) word(kStatus) &= ~pt::kStatusEstopMask;
      if ((value & pt::kEstopClearWatchdogMask) != 0) word(kStatus) &= ~pt::kStatusWatchdogMask, in_a_row_ = 0;
      return;
    case kFault.value:
    case (kEncoder + en::kFaultOffset).value:
      target &= ~value;
      return;
    case (kPulses + pt::kCommitOffset).value:
      if (!stopped()) commit(value);
      return;
    case (kPulses + pt::kTickCyclesOffset).value:
      refuse_if_protected(addr);
      if (value != kTick) refuse("a tick of cycles", value);
      return;
    case (kPulses + pt::kDirSetupOffset).value:
    case (kPulses + pt::kDirHoldOffset).value:
    case (kPulses + pt::kWatchdogOffset).value:
      refuse_if_protected(addr);
      break;
    case (kSwitch + sw::kSelectOffset).value:
      if (value != target) decoded_ += count(target) - count(value) + switch_artefact;
      break;
    case (kTool + io::kDataOffset).value:
      if (word(kTool + io::kTriOffset) != 0) refuse("outputs that are not driven", value);
      break;
    case (kTool + io::kIsrOffset).value:
      target ^= value & (io::kIsrChannel1Mask | io::kIsrChannel2Mask);
      return;
    default:
      break;
  }
  target = value;
  const std::uint32_t place = (addr.value - (kPulses + pw::kWidthOffset).value) / pw::kWidthStride;
  if (paper_ && place < kAxes && !stopped()) word(kStatus) |= 1u << (pw::kStatusArmed.lsb + place);
}

void FakeLogic::refuse_if_protected(RegAddr addr) const {
  if (!paper_ && servo_on() != 0) refuse("write of the protected register", addr.value);
}

void FakeLogic::commit(std::uint32_t sequence) {
  if ((word(kStatus) & pt::kStatusPendingMask) != 0) {
    word(kFault) |= pt::kFaultRecommitMask;
    ++recommits_;
  }
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::int64_t count = regs::extract_signed(word(element(kPulses, pt::kCountOffset, axis)), pt::kCountValue);
    pending_[axis] = std::clamp(count, -kLargestCount, kLargestCount);
    if (pending_[axis] != count) word(kFault) |= pt::kFaultClippedMask;
  }
  word(kPulses + pt::kCommitOffset) = sequence;
  word(kStatus) |= pt::kStatusPendingMask;
}

}  // namespace armature::test
