#include "controller/drivers/single_encoder.hpp"

#include "controller/regs/encoder_regs.hpp"

namespace armature {
namespace {

using namespace regs::encoder;
using regs::extract;
using regs::extract_signed;
using regs::insert;

constexpr std::uint32_t kOneAxis = 1;
constexpr std::uint32_t kId = insert(kIdWord, kIdAxes, kOneAxis);

}  // namespace

bool SingleEncoder::identified() noexcept {
  return bus_.read32(base_ + kIdOffset) == kId;
}

bool SingleEncoder::known() noexcept {
  return (extract(bus_.read32(base_ + kKnownOffset), kKnownAxes) & kOneAxis) != 0;
}

std::int32_t SingleEncoder::position() noexcept {
  return extract_signed(bus_.read32(base_ + kPositionOffset), kPositionValue);
}

std::uint32_t SingleEncoder::trigger_time() noexcept {
  return bus_.read32(base_ + kTriggerTimeOffset);
}

bool SingleEncoder::illegal_flag() noexcept {
  return (extract(bus_.read32(base_ + kFaultOffset), kFaultIllegal) & kOneAxis) != 0;
}

void SingleEncoder::clear_illegal_flag() noexcept {
  bus_.write32(base_ + kFaultOffset, insert(0, kFaultIllegal, kOneAxis));
}

}  // namespace armature
