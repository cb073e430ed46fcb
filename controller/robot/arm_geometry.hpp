// The geometry of an arm as data, for the two families with a closed-form inverse. A new arm of a family is a new set
// of numbers. Lengths in mm, standard Denavit-Hartenberg parameters.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/members.hpp"
#include "controller/base/misfit.hpp"

namespace armature {

enum class ArmFamily : std::uint8_t {
  kNone,   // joint moves only
  kSixR,   // Vo 2021 Table 2: alpha = 90 0 90 -90 90 0 deg, a = a1 a2 a3 0 0 0, d = d1 0 0 d4 0 d6; spherical wrist
  kFiveR,  // Hu 2012 Table 1: alpha = -90 0 0 -90 0 deg, a = a1 a2 a3 a4 0, d = 0 0 0 0 d5; z of the base points down
           // with positive theta_2
};

struct ArmGeometry {
  ArmFamily family = ArmFamily::kNone;
  // Lengths; those that the family does not use are 0. a2 > 0; the forearm (hypot(a3, d4) or a3) is not 0.
  double a1_mm = 0.0, a2_mm = 0.0, a3_mm = 0.0, a4_mm = 0.0;
  double d1_mm = 0.0, d4_mm = 0.0, d5_mm = 0.0, d6_mm = 0.0;

  // theta = sign * q + offset: from the vendor's joint angle q, which users, limits and drives use, to the
  // Denavit-Hartenberg angle. Signs are +1 or -1.
  PerAxis<double> sign{1, 1, 1, 1, 1, 1};
  PerAxis<double> offset_rad{};

  // kFiveR: a pose that five joints cannot reach is replaced by the nearest one that they can. This is the largest
  // rotation allowed for that; poses farther away are refused. (Hu 2012 does not treat this case.)
  double max_projection_rad = 0.0;

  [[nodiscard]] constexpr const void* misfit() const noexcept {
    const auto is_sign = [](double of_axis) { return of_axis == 1.0 || of_axis == -1.0; };
    return first_misfit({{&a1_mm, is_finite(a1_mm)},
                         {&a2_mm, family == ArmFamily::kNone ? is_finite(a2_mm) : is_positive(a2_mm)},
                         {&a3_mm, is_finite(a3_mm)},
                         {&a4_mm, is_finite(a4_mm)},
                         {&d1_mm, is_finite(d1_mm)},
                         {&d4_mm, is_finite(d4_mm)},
                         {&d5_mm, is_finite(d5_mm)},
                         {&d6_mm, is_finite(d6_mm)},
                         {&sign, std::all_of(sign.begin(), sign.end(), is_sign)},
                         {&offset_rad, are_finite(offset_rad)},
                         {&max_projection_rad, is_at_least_0(max_projection_rad)}});
  }
  ARMATURE_MEMBERS(ArmGeometry, family, a1_mm, a2_mm, a3_mm, a4_mm, d1_mm, d4_mm, d5_mm, d6_mm, sign, offset_rad,
                   max_projection_rad)
};

}  // namespace armature
