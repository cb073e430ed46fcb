// The words of ik_cordic for an arm.
#pragma once

#include "controller/drivers/ik_cordic.hpp"
#include "controller/kinematics/fixed/fixed_point.hpp"

namespace armature {

[[nodiscard]] constexpr IkCordic::Geometry geometry_words(const FixedArm& arm) noexcept {
  return {
      .a1 = arm.a1, .d1 = arm.d1, .a2 = arm.a2, .forearm = arm.forearm, .a4 = arm.a4, .hand = arm.hand, .phi = arm.phi};
}

}  // namespace armature
