#include "controller/drivers/ik_cordic.hpp"

#include "controller/regs/ik_cordic_regs.hpp"

namespace armature {
namespace {

namespace reg = regs::ik_cordic;
using regs::extract;

static_assert(reg::kIdBranchesReset == IkCordic::kBranches);
static_assert(reg::kThetaCount == IkCordic::kBranches * IkCordic::kJoints);

constexpr std::uint32_t element(std::uint32_t first, std::size_t index) {
  return first + 4 * static_cast<std::uint32_t>(index);
}
constexpr std::uint32_t word(std::int32_t value) {
  return static_cast<std::uint32_t>(value);
}

}  // namespace

bool IkCordic::identified() noexcept {
  return bus_.read32(base_ + reg::kIdOffset) == reg::kIdWord;
}

void IkCordic::set_geometry(const Geometry& geometry) noexcept {
  bus_.write32(base_ + reg::kA1Offset, word(geometry.a1));
  bus_.write32(base_ + reg::kD1Offset, word(geometry.d1));
  bus_.write32(base_ + reg::kA2Offset, word(geometry.a2));
  bus_.write32(base_ + reg::kForearmOffset, word(geometry.forearm));
  bus_.write32(base_ + reg::kA4Offset, word(geometry.a4));
  bus_.write32(base_ + reg::kHandOffset, word(geometry.hand));
  bus_.write32(base_ + reg::kPhiOffset, word(geometry.phi));
}

void IkCordic::set_rotation(std::size_t entry, std::int32_t value) noexcept {
  bus_.write32(base_ + element(reg::kRotationOffset, entry), word(value));
}

void IkCordic::set_position(std::size_t coordinate, std::int32_t value) noexcept {
  bus_.write32(base_ + element(reg::kPositionOffset, coordinate), word(value));
}

void IkCordic::set_previous(const std::array<std::int32_t, 3>& angles) noexcept {
  for (std::size_t i = 0; i < angles.size(); ++i) {
    bus_.write32(base_ + element(reg::kPreviousOffset, i), word(angles[i]));
  }
}

void IkCordic::start(bool five_axes) noexcept {
  bus_.write32(base_ + reg::kCtrlOffset, reg::kCtrlStartMask | (five_axes ? reg::kCtrlFiveRMask : 0U));
}

bool IkCordic::done() noexcept {
  return (bus_.read32(base_ + reg::kStatusOffset) & reg::kStatusDoneMask) != 0;
}

IkCordic::Flags IkCordic::flags() noexcept {
  const std::uint32_t flags = bus_.read32(base_ + reg::kFlagsOffset);
  const auto bits = [flags](regs::Field field) { return static_cast<std::uint8_t>(extract(flags, field)); };
  return {.shoulder_singular = bits(reg::kFlagsShoulder) != 0,
          .elbow_singular = bits(reg::kFlagsElbow),
          .clamped = bits(reg::kFlagsClamped),
          .folded = bits(reg::kFlagsFolded),
          .wrist_singular = bits(reg::kFlagsWrist)};
}

std::uint8_t IkCordic::branches() noexcept {
  return static_cast<std::uint8_t>(extract(bus_.read32(base_ + reg::kBranchesOffset), reg::kBranchesValid));
}

std::int32_t IkCordic::theta(std::size_t branch, std::size_t joint) noexcept {
  return static_cast<std::int32_t>(bus_.read32(base_ + element(reg::kThetaOffset, kJoints * branch + joint)));
}

std::uint32_t IkCordic::cycles() noexcept {
  return extract(bus_.read32(base_ + reg::kCyclesOffset), reg::kCyclesValue);
}

}  // namespace armature
