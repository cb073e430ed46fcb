#include "cosim/model/ik_cordic/ik_cordic.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace armature::cosim::model {
namespace {

namespace reg = regs::ik_cordic;

// Offsets of the registers that a start copies.
struct Input {
  std::uint32_t offset, mask;
};
constexpr std::uint32_t kWholeWord = 0xFFFF'FFFF;
constexpr std::size_t kA1 = 12;
constexpr auto kInputOffsets = [] {
  std::array<Input, 22> inputs{};
  const auto elements = [&inputs](std::size_t first, std::uint32_t offset, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      inputs[first + i] = {offset + 4 * static_cast<std::uint32_t>(i), kWholeWord};
  };
  elements(0, reg::kRotationOffset, reg::kRotationCount);
  elements(9, reg::kPositionOffset, reg::kPositionCount);
  elements(kA1, reg::kA1Offset, 7);  // A1 D1 A2 FOREARM A4 HAND PHI
  inputs[kA1 + 2].mask = reg::kA2LengthMask;
  inputs[kA1 + 3].mask = reg::kForearmLengthMask;
  elements(19, reg::kPreviousOffset, reg::kPreviousCount);
  return inputs;
}();

[[nodiscard]] std::optional<std::size_t> input_at(std::uint32_t offset) {
  const auto found = std::ranges::find(kInputOffsets, offset, &Input::offset);
  if (found == kInputOffsets.end()) return std::nullopt;
  return static_cast<std::size_t>(found - kInputOffsets.begin());
}

[[nodiscard]] ik::Job job_of(const std::array<std::uint32_t, 22>& words, bool five_r) {
  const auto at = [&words](std::size_t i) { return static_cast<std::int32_t>(words[i]); };
  ik::Job job{.five_r = five_r};
  for (std::size_t i = 0; i < job.rotation.size(); ++i) job.rotation[i] = at(i);
  for (std::size_t i = 0; i < job.position.size(); ++i) job.position[i] = at(9 + i);
  job.a1 = at(kA1);
  job.base = at(kA1 + 1);
  job.upper = words[kA1 + 2];
  job.fore = words[kA1 + 3];
  job.a4 = at(kA1 + 4);
  job.hand = at(kA1 + 5);
  job.phi = at(kA1 + 6);
  job.previous1 = at(19);
  job.previous2 = at(20);
  job.previous4 = at(21);
  return job;
}

[[nodiscard]] constexpr std::uint32_t field(std::uint32_t value, std::uint32_t mask) {
  return value * (mask & ~(mask - 1));  // from bit 0 to the place of the field
}

}  // namespace

Answer IkCordic::edge(Cycles at, const Strobes& access, const IkInputs& /*inputs*/) {
  Answer answer;
  if (access.read) answer = read(at, word_offset(access.raddr));
  // All levels before the edge.
  const bool interrupt = interrupts(), start = start_, five_r = five_r_, busy = is_busy();
  irq_ = interrupt;
  start_ = false;
  const bool sets_event = std::exchange(ended_, false);
  if (busy) continue_run(at);
  if (start && busy) refused_ = true;
  if (start && !busy) {
    state_ = State::kCopies;
    started_ = at;
    copied_ = words_;
    copied_five_r_ = five_r;
    done_ = refused_ = false;
    solved_ = ik::unsolved();
  }
  if (access.write) answer.werr = write(at, access);
  if (sets_event) done_event_ = true;  // wins over a write that clears it
  const Cycles next = at + Cycles{1};
  if (start_ || ended_ || irq_ != interrupts()) {
    wakes_at_ = next;
  } else {
    wakes_at_ = state_ == State::kCopies ? started_ + Cycles{kInputs} : state_ == State::kSolves ? ends_ : kNever;
  }
  return answer;
}

void IkCordic::continue_run(Cycles at) {
  if (state_ == State::kCopies && at >= started_ + Cycles{kInputs}) {
    solved_ = solve(job_of(copied_, copied_five_r_));
    ends_ = started_ + Cycles{solved_.clocks};
    state_ = State::kSolves;
  }
  if (state_ == State::kSolves && at == ends_) {
    state_ = State::kIdle;
    done_ = ended_ = true;
  }
}

Answer IkCordic::read(Cycles at, std::uint32_t offset) const {
  const auto word = [](std::uint32_t value) { return Answer{.rdata = value}; };
  if (const auto input = input_at(offset)) return word(words_[*input]);
  switch (offset) {
    case reg::kIdOffset:
      return word(reg::kIdWord);
    case reg::kCtrlOffset:
      return word(field(five_r_, reg::kCtrlFiveRMask) | field(irq_enabled_, reg::kCtrlIrqMask));
    case reg::kStatusOffset:
      return word(field(is_busy(), reg::kStatusBusyMask) | field(done_, reg::kStatusDoneMask) |
                  field(refused_, reg::kStatusRefusedMask));
    case reg::kEventOffset:
      return word(field(done_event_, reg::kEventDoneMask));
    case reg::kCyclesOffset:
      return word(is_busy() ? static_cast<std::uint32_t>((at - started_).value() - 1)
                            : static_cast<std::uint32_t>(solved_.clocks));
    case reg::kBranchesOffset:
      return word(is_busy() ? 0u : solved_.valid);
    case reg::kFlagsOffset:
      return word(is_busy() ? 0u : flags());
    default:
      break;
  }
  if (const auto theta = element(offset, reg::kThetaOffset, 4, reg::kThetaCount)) {
    return word(is_busy() ? 0u : static_cast<std::uint32_t>(solved_.theta[*theta / ik::kJoints][*theta % ik::kJoints]));
  }
  return kUnmappedRead;
}

std::uint32_t IkCordic::flags() const {
  return field(solved_.shoulder_singular, reg::kFlagsShoulderMask) |
         field(solved_.elbow_singular, reg::kFlagsElbowMask) | field(solved_.clamped, reg::kFlagsClampedMask) |
         field(solved_.folded, reg::kFlagsFoldedMask) | field(solved_.wrist_singular, reg::kFlagsWristMask);
}

bool IkCordic::write(Cycles at, const Strobes& access) {
  const std::uint32_t offset = word_offset(access.waddr);
  if (const auto input = input_at(offset)) {
    words_[*input] = merged(words_[*input], access) & kInputOffsets[*input].mask;
    if (state_ == State::kCopies && at < started_ + Cycles{1} + Cycles{static_cast<std::int64_t>(*input)}) {
      copied_[*input] = words_[*input];
    }
    return false;
  }
  const bool low_byte = (access.wstrb & 1u) != 0;
  const auto is_set = [&access](std::uint32_t mask) { return (access.wdata & mask) != 0; };
  switch (offset) {
    case reg::kCtrlOffset:
      if (!low_byte) return false;
      start_ = is_set(reg::kCtrlStartMask);
      five_r_ = is_set(reg::kCtrlFiveRMask);
      irq_enabled_ = is_set(reg::kCtrlIrqMask);
      return false;
    case reg::kEventOffset:
      if (low_byte && is_set(reg::kEventDoneMask)) done_event_ = false;
      return false;
    default:
      return true;
  }
}

}  // namespace armature::cosim::model
