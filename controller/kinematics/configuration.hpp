// The configuration of an arm: on which side of each singularity it is, and how many turns its joints have made. A pose
// has up to eight solutions, and more with turns. Each has a configuration of its own.
//
// The sides are those of industrial robots:
//   shoulder  front: joint 1 faces the wrist centre (five joints: the flange). back: joint 1 faces away from it
//   elbow     up: seen with the wrist in front of the arm, the elbow is above the line from joint 2 to the wrist
//   wrist     no flip: with joint 4 at the zero of its Denavit-Hartenberg angle, joint 5 bends the hand down from the
//             forearm (theta_5 < 0). flip: it bends the hand up. Only for arms with a spherical wrist
// Along a path a side changes only at its singularity. So the start of a line determines the configuration at its end.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/base/axes.hpp"
#include "controller/base/members.hpp"

namespace armature {

// kNearest in a request: not requested. In an arm's configuration: not determined, because the arm is at the
// singularity or has no such side.
enum class ShoulderSide : std::uint8_t { kNearest, kFront, kBack };
enum class ElbowSide : std::uint8_t { kNearest, kUp, kDown };
enum class WristSide : std::uint8_t { kNearest, kNoflip, kFlip };

// Of each joint: n for an angle from n * 360 - 180 deg to n * 360 + 180 deg. Axes that the arm does not have: 0.
using Turns = PerAxis<std::int8_t>;
inline constexpr int kMaxTurns = 100;  // in both directions

struct Configuration {
  ShoulderSide shoulder = ShoulderSide::kNearest;
  ElbowSide elbow = ElbowSide::kNearest;
  WristSide wrist = WristSide::kNearest;
  std::optional<Turns> turns{};  // none in a request: not requested

  friend constexpr bool operator==(const Configuration&, const Configuration&) noexcept = default;
  ARMATURE_MEMBERS(Configuration, shoulder, elbow, wrist, turns)
};

// Parts of a configuration, as a mask.
enum ConfigurationPart : std::uint8_t { kShoulderPart = 1, kElbowPart = 2, kWristPart = 4, kTurnsPart = 8 };

// The sides for the signs of a branch (IkBranch), 0 where a sign is not determined. Without turns.
[[nodiscard]] Configuration configuration_of(int shoulder, int elbow, int flip) noexcept;

// The parts that are requested.
[[nodiscard]] std::uint8_t requested_parts(const Configuration& wanted) noexcept;

// The requested sides that the arm does not have. A side that is not determined fits any request. Turns are not
// compared.
[[nodiscard]] std::uint8_t differing_sides(const Configuration& wanted, const Configuration& actual) noexcept;

// The number of turns of an angle [rad] within kMaxTurns.
[[nodiscard]] std::int8_t turns_of(double angle_rad) noexcept;
// True if the angle belongs to this number of turns. At half a turn it belongs to both neighbours.
[[nodiscard]] bool has_turns(double angle_rad, std::int8_t turns) noexcept;

}  // namespace armature
