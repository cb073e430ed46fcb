#include "controller/drivers/encoder.hpp"

#include "controller/regs/encoder_regs.hpp"

namespace armature {
namespace {

using namespace regs::encoder;
using regs::extract;
using regs::extract_signed;
using regs::insert;

static_assert(kPositionCount == kAxes && kCountsPerRevCount == kAxes && kIdAxesReset == kAxes);

}  // namespace

bool Encoder::identified() noexcept {
  return bus_.read32(base_ + kIdOffset) == kIdWord;
}

void Encoder::configure(const PerAxis<std::int32_t>& counts_per_rev, std::uint8_t zero_axes) noexcept {
  for (std::uint32_t axis = 0; axis < kAxes; ++axis) {
    const auto counts = static_cast<std::uint32_t>(counts_per_rev[axis]);
    bus_.write32(base_ + (kCountsPerRevOffset + axis * kCountsPerRevStride), insert(0, kCountsPerRevValue, counts));
  }
  bus_.write32(base_ + kIndexCheckOffset, insert(kIndexCheckEnableMask, kIndexCheckFirst, zero_axes));
}

std::uint8_t Encoder::known() noexcept {
  return static_cast<std::uint8_t>(extract(bus_.read32(base_ + kKnownOffset), kKnownAxes));
}

PerAxis<std::int32_t> Encoder::positions() noexcept {
  PerAxis<std::int32_t> counts;
  for (std::uint32_t axis = 0; axis < kAxes; ++axis) {
    counts[axis] = extract_signed(bus_.read32(base_ + (kPositionOffset + axis * kPositionStride)), kPositionValue);
  }
  return counts;
}

std::optional<std::int32_t> Encoder::index_position(std::size_t axis) noexcept {
  const std::uint32_t seen = extract(bus_.read32(base_ + kIndexSeenOffset), kIndexSeenAxes);
  if (((seen >> axis) & 1u) == 0) return std::nullopt;
  const std::uint32_t offset = kIndexPositionOffset + static_cast<std::uint32_t>(axis) * kIndexPositionStride;
  return extract_signed(bus_.read32(base_ + offset), kIndexPositionValue);
}

Encoder::Faults Encoder::faults() noexcept {
  const std::uint32_t word = bus_.read32(base_ + kFaultOffset);
  return {.illegal = static_cast<std::uint8_t>(extract(word, kFaultIllegal)),
          .index = static_cast<std::uint8_t>(extract(word, kFaultIndex))};
}

void Encoder::clear(const Faults& faults) noexcept {
  bus_.write32(base_ + kFaultOffset, insert(insert(0, kFaultIllegal, faults.illegal), kFaultIndex, faults.index));
}

}  // namespace armature
