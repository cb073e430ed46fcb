#include "cosim/model/timer/axi_timer.hpp"

#include <utility>

namespace armature::cosim::model {
namespace {

namespace timer_regs = regs::axi_timer;

// From here on every access is an error. Words below without a register read 0 and ignore writes.
constexpr std::uint32_t kTimerMapEnd = 0x20;

constexpr std::uint32_t kPlainBits = timer_bits::kCapture | timer_bits::kDown | timer_bits::kGenerate |
                                     timer_bits::kCapturePin | timer_bits::kReload | timer_bits::kLoad |
                                     timer_bits::kIrq | timer_bits::kRun | timer_bits::kPwm;

}  // namespace

Answer AxiTimer::edge(Cycles at, const Strobes& access, const TimerInputs& inputs) {
  Answer result;
  if (stopped_) return result;
  if (access.any()) result = answer(at, access);
  const bool same = inputs == TimerInputs{.capture_trig = capture_.ago(1), .freeze = freeze_.ago(1)};
  if (same && is_steady_ && at < counting_until_ && (!access.write || clears_flags(access))) {
    if (access.write || wakes_at_ <= at) clear_flags(at, access);
  } else if (access.write || !same || wakes_at_ <= at) {
    compute(at, access, inputs);
  }
  return result;
}

void AxiTimer::stop_gated_clock() {
  stopped_ = true;
  wakes_at_ = kNever;
}

Answer AxiTimer::answer(Cycles at, const Strobes& access) const {
  Answer result;
  result.werr = access.write && word_offset(access.waddr) >= kTimerMapEnd;
  if (!access.read) return result;
  const std::uint32_t offset = word_offset(access.raddr);
  result.rerr = offset >= kTimerMapEnd;
  result.rdata = result.rerr ? kUnmappedData : word(offset, at - Cycles{1});
  return result;
}

std::uint32_t AxiTimer::word(std::uint32_t offset, Cycles at) const {
  switch (offset) {
    case timer_regs::kTcsr0Offset:
      return tcsr(0);
    case timer_regs::kTlr0Offset:
      return tlr(0);
    case timer_regs::kTcr0Offset:
      return tcr(0, at);
    case timer_regs::kTcsr1Offset:
      return tcsr(1);
    case timer_regs::kTlr1Offset:
      return tlr(1);
    case timer_regs::kTcr1Offset:
      return tcr(1, at);
    default:
      return 0;
  }
}

std::uint32_t AxiTimer::tcsr(unsigned timer) const {
  const std::uint32_t cascade = cascade_ && timer == 0 ? timer_bits::kCascade : 0;
  return registers_[timer].control | (run_all_ ? timer_bits::kRunAll : 0) | cascade;
}

bool AxiTimer::interrupts() const {
  return registers_[0].interrupts() || (registers_[1].interrupts() && !cascade_);
}
bool AxiTimer::asks_for_pwm() const {
  return registers_[0].asks_for_pwm() && registers_[1].asks_for_pwm() && !cascade_;
}

// Bit i: the pin makes timer i capture at this edge. In a cascade timer 0 decides for both.
unsigned AxiTimer::captures() const {
  if (!capture_.ago(3) || capture_.ago(4)) return 0;
  unsigned timers = 0;
  for (unsigned i = 0; i < (cascade_ ? 1u : 2u); ++i) {
    const bool first = !registers_[i].has(timer_bits::kFlag);
    if (registers_[i].captures() && (first || registers_[i].has(timer_bits::kReload))) timers |= 1u << i;
  }
  return timers;
}

void AxiTimer::compute(Cycles at, const Strobes& access, const TimerInputs& inputs) {
  const TimerRegisterPair before = registers_;
  const bool cascade = cascade_;
  const bool pwm_mode = std::exchange(pwm_mode_, asks_for_pwm());
  const unsigned captured = captures();
  const Cycles previous = at - Cycles{1};
  const std::uint32_t counts[2] = {counters_.count(0, previous), counters_.count(1, previous)};

  irq_ = interrupts();
  const unsigned ends = counters_.edge(at, before, {.cascade = cascade, .pwm = pwm_mode, .frozen = freeze_.ago(2)});
  pwm_.edge(pwm_mode, (ends & 1u) != 0, (ends & 2u) != 0, before[1].has(timer_bits::kRun));
  pulses_ = 0;
  if (access.write) write(access);
  // Events win over the write.
  const unsigned stores = cascade && captured != 0 ? 3u : captured;
  for (unsigned i = 0; i < 2; ++i) {
    if ((ends >> i & 1u) != 0 && before[i].has(timer_bits::kGenerate)) pulses_ |= 1u << i;
    if (((ends | captured) >> i & 1u) != 0) registers_[i].control |= timer_bits::kFlag;
    if ((stores >> i & 1u) != 0) registers_[i].start = counts[i];
  }
  capture_.sample(inputs.capture_trig);
  freeze_.sample(inputs.freeze);
  wakes_at_ = plan(at);
}

Cycles AxiTimer::plan(Cycles at) {
  counting_until_ = counters_.plan(registers_, {.cascade = cascade_, .pwm = pwm_mode_, .frozen = freeze_.ago(2)});
  is_steady_ = pulses_ == 0 && pwm_mode_ == asks_for_pwm() && pwm_.is_settled(pwm_mode_) && capture_.are_equal() &&
               freeze_.are_equal();
  return is_steady_ && irq_ == interrupts() ? counting_until_ : at + Cycles{1};
}

// Whether the write does nothing to a control register but clear its flag: what acknowledges an interrupt.
bool AxiTimer::clears_flags(const Strobes& access) const {
  const std::uint32_t offset = word_offset(access.waddr);
  if (offset != timer_regs::kTcsr0Offset && offset != timer_regs::kTcsr1Offset) return false;
  const std::uint32_t before = tcsr(offset == timer_regs::kTcsr1Offset ? 1 : 0) & ~timer_bits::kFlag;
  return (merged(before, access) & ~timer_bits::kFlag) == before && !writes_run_all(access);
}

// An edge at which only flags and the interrupt change, with such a write or none.
void AxiTimer::clear_flags(Cycles at, const Strobes& access) {
  irq_ = interrupts();
  if (access.write) write(access);
  wakes_at_ = irq_ == interrupts() ? counting_until_ : at + Cycles{1};
}

void AxiTimer::write(const Strobes& access) {
  switch (word_offset(access.waddr)) {
    case timer_regs::kTcsr0Offset:
      write_control(0, access);
      break;
    case timer_regs::kTcsr1Offset:
      write_control(1, access);
      break;
    case timer_regs::kTlr0Offset:
      registers_[0].start = merged(registers_[0].start, access);
      break;
    case timer_regs::kTlr1Offset:
      registers_[1].start = merged(registers_[1].start, access);
      break;
    default:  // TCR, reserved words, errors
      break;
  }
}

// The write starts both timers, not the bit: a write of other bytes starts nothing.
bool AxiTimer::writes_run_all(const Strobes& access) {
  return (access.wstrb & 2u) != 0 && (access.wdata & timer_bits::kRunAll) != 0;
}

void AxiTimer::write_control(unsigned timer, const Strobes& access) {
  TimerRegisters& registers = registers_[timer];
  const std::uint32_t value = merged(tcsr(timer) & ~timer_bits::kFlag, access);
  registers.control = (registers.control & ~kPlainBits) | (value & kPlainBits);
  if ((value & timer_bits::kFlag) != 0) registers.control &= ~timer_bits::kFlag;
  if (timer == 0) cascade_ = (value & timer_bits::kCascade) != 0;
  run_all_ = (value & timer_bits::kRunAll) != 0;
  if (!writes_run_all(access)) return;
  for (TimerRegisters& each : registers_) each.control |= timer_bits::kRun;
}

}  // namespace armature::cosim::model
