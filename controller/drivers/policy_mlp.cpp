#include "controller/drivers/policy_mlp.hpp"

#include <algorithm>

#include "controller/regs/policy_mlp_regs.hpp"

namespace armature {
namespace {

namespace reg = regs::policy_mlp;
using regs::extract;

static_assert(reg::kInputCount == PolicyMlp::kInputs / 4);
static_assert(reg::kOutputCount == PolicyMlp::kOutputs / 4);
constexpr std::size_t kBytesOfWord = 4;

}  // namespace

bool PolicyMlp::identified() noexcept {
  return bus_.read32(base_ + reg::kIdOffset) == reg::kIdWord;
}

void PolicyMlp::load(std::span<const std::uint32_t> image, std::uint32_t crc) noexcept {
  begin_load();
  load_next(image.first(std::min(image.size(), kMemoryWords)));
  end_load(crc);
}

void PolicyMlp::begin_load() noexcept {
  bus_.write32(base_ + reg::kAddressOffset, 0);
}

void PolicyMlp::load_next(std::span<const std::uint32_t> words) noexcept {
  for (const std::uint32_t word : words) bus_.write32(base_ + reg::kDataOffset, word);
}

void PolicyMlp::end_load(std::uint32_t crc) noexcept {
  bus_.write32(base_ + reg::kCrcOffset, crc);
}

void PolicyMlp::set_bound(std::uint8_t bound) noexcept {
  bus_.write32(base_ + reg::kBoundOffset, bound);
}

void PolicyMlp::set_inputs(std::span<const std::int8_t> inputs) noexcept {
  const std::size_t count = std::min(inputs.size(), kInputs);
  for (std::size_t first = 0; first < count; first += kBytesOfWord) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < kBytesOfWord && first + i < count; ++i) {
      word |= std::uint32_t{static_cast<std::uint8_t>(inputs[first + i])} << (8 * i);
    }
    bus_.write32(base_ + (reg::kInputOffset + static_cast<std::uint32_t>(first)), word);
  }
}

void PolicyMlp::start() noexcept {
  bus_.write32(base_ + reg::kCtrlOffset, reg::kCtrlStartMask);
}

PolicyMlp::Status PolicyMlp::status() noexcept {
  const std::uint32_t status = bus_.read32(base_ + reg::kStatusOffset);
  const auto is = [status](std::uint32_t mask) { return (status & mask) != 0; };
  return {.busy = is(reg::kStatusBusyMask),
          .done = is(reg::kStatusDoneMask),
          .refused = is(reg::kStatusRefusedMask),
          .corrupt = is(reg::kStatusCorruptMask),
          .malformed = is(reg::kStatusMalformedMask)};
}

std::array<std::int8_t, PolicyMlp::kOutputs> PolicyMlp::outputs() noexcept {
  std::array<std::int8_t, kOutputs> values{};
  for (std::size_t first = 0; first < kOutputs; first += kBytesOfWord) {
    const std::uint32_t word = bus_.read32(base_ + (reg::kOutputOffset + static_cast<std::uint32_t>(first)));
    for (std::size_t i = 0; i < kBytesOfWord; ++i) values[first + i] = static_cast<std::int8_t>(word >> (8 * i));
  }
  return values;
}

std::uint32_t PolicyMlp::cycles() noexcept {
  return extract(bus_.read32(base_ + reg::kCyclesOffset), reg::kCyclesValue);
}

}  // namespace armature
