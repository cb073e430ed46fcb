// Which activity, and how it is stopped.
#pragma once

#include <cstddef>
#include <cstdint>

namespace armature {

enum class ActivityId : std::uint8_t { kPlans, kJog, kStream, kHoming, kConveyor };
inline constexpr std::size_t kActivities = 5;

// From the weakest to the strongest one.
enum class StopKind : std::uint8_t {
  kHold,   // within the limits of the motion; plans continue afterwards
  kSoft,   // within the limits of the motion
  kQuick,  // with the full acceleration of the joints
};

}  // namespace armature
