#include "cosim/model/policy_mlp/policy_mlp.hpp"

#include <algorithm>
#include <utility>

namespace armature::cosim::model {
namespace {

namespace policy_map = regs::policy_mlp;

static_assert(policy_map::kInputCount == mlp::kInputs / 4 && policy_map::kOutputCount == mlp::kOutputs / 4);

[[nodiscard]] constexpr std::uint32_t policy_flag(bool is_set, std::uint32_t mask) {
  return is_set ? mask : 0u;
}

[[nodiscard]] mlp::Inputs policy_inputs(const std::array<std::uint32_t, policy_map::kInputCount>& words) {
  mlp::Inputs bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::int8_t>(words[i / 4] >> (8 * (i % 4)));
  return bytes;
}

}  // namespace

Answer PolicyMlp::edge(Cycles at, const Strobes& access, const PolicyInputs& /*inputs*/) {
  Answer answer;
  if (access.read) answer = read(at, word_offset(access.raddr));
  // All levels before the edge.
  const bool interrupt = interrupts(), start = start_, busy = busy_;
  const mlp::Inputs inputs = start ? policy_inputs(inputs_) : mlp::Inputs{};
  irq_ = interrupt;
  start_ = false;
  const bool sets_event = std::exchange(ended_, false);
  if (busy && at == ends_) end_run();
  if (start && busy) refused_ = true;
  if (start && !busy) refused_ = done_ = corrupt_ = malformed_ = false;
  if (access.write) answer.werr = write(access, busy);
  if (start && !busy) {
    busy_ = true;
    started_ = at;
    run_ = mlp::evaluate(memory_, kLanes, inputs);  // the memory cannot change until the end
    ends_ = at + Cycles{run_.clocks};
  }
  if (sets_event) event_ = true;  // wins over a write that clears it
  wakes_at_ = start_ || ended_ || irq_ != interrupts() ? at + Cycles{1} : busy_ ? ends_ : kNever;
  return answer;
}

void PolicyMlp::end_run() {
  busy_ = false;
  ended_ = true;
  malformed_ = run_.malformed;
  corrupt_ = run_.crc != crc_;
  done_ = !malformed_ && !corrupt_;
}

std::uint32_t PolicyMlp::status() const {
  return policy_flag(busy_, policy_map::kStatusBusyMask) | policy_flag(done_, policy_map::kStatusDoneMask) |
         policy_flag(refused_, policy_map::kStatusRefusedMask) | policy_flag(corrupt_, policy_map::kStatusCorruptMask) |
         policy_flag(malformed_, policy_map::kStatusMalformedMask);
}

std::uint32_t PolicyMlp::outputs(std::size_t first) const {
  if (!done_) return 0;
  std::uint32_t word = 0;
  const int bound = static_cast<int>(bound_);
  for (std::size_t i = 0; i < 4; ++i) {
    const int limited = std::clamp<int>(run_.outputs[first + i], -bound, bound);
    word |= static_cast<std::uint32_t>(static_cast<std::uint8_t>(limited)) << (8 * i);
  }
  return word;
}

Answer PolicyMlp::read(Cycles at, std::uint32_t offset) const {
  const auto word = [](std::uint32_t value) { return Answer{.rdata = value}; };
  switch (offset) {
    case policy_map::kIdOffset:
      return word(policy_map::kIdWord);
    case policy_map::kCtrlOffset:
      return word(policy_flag(irq_enabled_, policy_map::kCtrlIrqMask));
    case policy_map::kStatusOffset:
      return word(status());
    case policy_map::kEventOffset:
      return word(policy_flag(event_, policy_map::kEventEndedMask));
    case policy_map::kCyclesOffset:
      return word(static_cast<std::uint32_t>(busy_ ? (at - started_).value() - 1 : run_.clocks));
    case policy_map::kBoundOffset:
      return word(bound_);
    case policy_map::kCrcOffset:
      return word(crc_);
    case policy_map::kCrcReadOffset:
      return word(busy_ ? 0u : run_.crc);
    case policy_map::kAddressOffset:
      return word(address_);
    case policy_map::kDataOffset:
      return word(0);
    default:
      break;
  }
  if (const auto input = element(offset, policy_map::kInputOffset, 4, policy_map::kInputCount))
    return word(inputs_[*input]);
  if (const auto output = element(offset, policy_map::kOutputOffset, 4, policy_map::kOutputCount))
    return word(outputs(4 * *output));
  return kUnmappedRead;
}

bool PolicyMlp::write(const Strobes& access, bool busy) {
  const std::uint32_t offset = word_offset(access.waddr);
  if (const auto input = element(offset, policy_map::kInputOffset, 4, policy_map::kInputCount)) {
    inputs_[*input] = merged(inputs_[*input], access);
    return false;
  }
  switch (offset) {
    case policy_map::kCtrlOffset:
      write_control(access);
      return false;
    case policy_map::kEventOffset:
      if ((written_bits(access) & access.wdata & policy_map::kEventEndedMask) != 0) event_ = false;
      return false;
    case policy_map::kBoundOffset:
      bound_ = merged(bound_, access) & policy_map::kBoundValueMask;
      return false;
    case policy_map::kCrcOffset:
      crc_ = merged(crc_, access);
      return false;
    case policy_map::kAddressOffset:
      address_ = merged(address_, access) & policy_map::kAddressWordMask;
      return false;
    case policy_map::kDataOffset:
      store(access, busy);
      return false;
    default:
      return true;
  }
}

void PolicyMlp::write_control(const Strobes& access) {
  if ((access.wstrb & 1u) == 0) return;
  start_ = (access.wdata & policy_map::kCtrlStartMask) != 0;
  irq_enabled_ = (access.wdata & policy_map::kCtrlIrqMask) != 0;
}

void PolicyMlp::store(const Strobes& access, bool busy) {
  if (access.wstrb != 0xF) return;
  if (busy) {
    refused_ = true;
    return;
  }
  memory_[address_] = access.wdata;
  address_ = (address_ + 1) & policy_map::kAddressWordMask;
}

}  // namespace armature::cosim::model
