// One set-point of a stream, from core 1 to core 0.
#pragma once

#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/tag.hpp"
#include "controller/base/units.hpp"
#include "controller/trajectory/profile/time_law.hpp"

namespace armature {

struct StreamSample {
  enum class Kind : std::uint8_t { kFirst, kNext, kLast };
  Kind kind = Kind::kFirst;
  PerAxis<double> joint_rad{};  // not for the stops
  Ticks time{};                 // since the first one, which has 0; strictly ascending
  // Of kFirst only.
  Ticks delay{};  // the arm follows the stream this much later than the first set-point came, > 0
  ProfileKind profile = ProfileKind::kTrapezoid;
  Tag tag{};
};

}  // namespace armature
