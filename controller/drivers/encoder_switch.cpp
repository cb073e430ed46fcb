#include "controller/drivers/encoder_switch.hpp"

#include "controller/regs/encoder_switch_regs.hpp"

namespace armature {
namespace {

using namespace regs::encoder_switch;
using regs::insert;

static_assert(kIdAxesReset == kAxes);

}  // namespace

bool EncoderSwitch::identified() noexcept {
  return bus_.read32(base_ + kIdOffset) == kIdWord;
}

void EncoderSwitch::select(std::size_t axis) noexcept {
  bus_.write32(base_ + kSelectOffset, insert(0, kSelectAxis, static_cast<std::uint32_t>(axis)));
}

}  // namespace armature
