#include "controller/kinematics/configuration.hpp"

#include <algorithm>
#include <cmath>

#include "controller/kinematics/branch_choice.hpp"
#include "controller/kinematics/turns.hpp"

namespace armature {
namespace {

// `positive` for a sign above 0, `negative` below 0.
template <class Side>
Side side_of(int sign, Side positive, Side negative) {
  return sign > 0 ? positive : sign < 0 ? negative : Side::kNearest;
}

template <class Side>
bool differs(Side wanted, Side actual) {
  return wanted != Side::kNearest && actual != Side::kNearest && wanted != actual;
}

}  // namespace

Configuration configuration_of(int shoulder, int elbow, int flip) noexcept {
  // Behind the arm the sign of the elbow is that of an arm seen from the other side.
  return {.shoulder = side_of(shoulder, ShoulderSide::kFront, ShoulderSide::kBack),
          .elbow = side_of(shoulder * elbow, ElbowSide::kUp, ElbowSide::kDown),
          .wrist = side_of(-flip, WristSide::kNoflip, WristSide::kFlip)};
}

std::uint8_t requested_parts(const Configuration& wanted) noexcept {
  return static_cast<std::uint8_t>((wanted.shoulder != ShoulderSide::kNearest ? kShoulderPart : 0) |
                                   (wanted.elbow != ElbowSide::kNearest ? kElbowPart : 0) |
                                   (wanted.wrist != WristSide::kNearest ? kWristPart : 0) |
                                   (wanted.turns ? kTurnsPart : 0));
}

std::uint8_t differing_sides(const Configuration& wanted, const Configuration& actual) noexcept {
  return static_cast<std::uint8_t>((differs(wanted.shoulder, actual.shoulder) ? kShoulderPart : 0) |
                                   (differs(wanted.elbow, actual.elbow) ? kElbowPart : 0) |
                                   (differs(wanted.wrist, actual.wrist) ? kWristPart : 0));
}

std::int8_t turns_of(double angle_rad) noexcept {
  constexpr double kMax = kMaxTurns;
  return static_cast<std::int8_t>(std::clamp(std::floor(angle_rad / kTurn_rad + 0.5), -kMax, kMax));
}

bool has_turns(double angle_rad, std::int8_t turns) noexcept {
  return std::fabs(angle_rad - turns * kTurn_rad) <= 0.5 * kTurn_rad + kLimitTolerance_rad;
}

}  // namespace armature
