// A rigid body in the frame of the link that carries it.
#pragma once

#include "cosim/dynamics/vector3.hpp"

namespace armature::cosim {

struct Body {
  double mass_kg = 0.0;
  Vector3 centre_m;          // centre of mass
  Symmetric3 inertia_kg_m2;  // about the centre of mass; xy is the element of the tensor, -integral of x y
};

// Two bodies that are fixed to each other, in one frame.
[[nodiscard]] constexpr Body together(const Body& a, const Body& b) {
  const double mass = a.mass_kg + b.mass_kg;
  if (mass == 0.0) return {};
  const Vector3 centre = (1.0 / mass) * (a.mass_kg * a.centre_m + b.mass_kg * b.centre_m);
  const double reduced = a.mass_kg * b.mass_kg / mass;
  const Symmetric3 apart = of_point(b.centre_m - a.centre_m);
  const Symmetric3 moved{reduced * apart.xx, reduced * apart.yy, reduced * apart.zz,
                         reduced * apart.xy, reduced * apart.xz, reduced * apart.yz};
  return {mass, centre, a.inertia_kg_m2 + b.inertia_kg_m2 + moved};
}

}  // namespace armature::cosim
