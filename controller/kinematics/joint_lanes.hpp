// One joint in two branches at once: its turns, its limits and the time of its move. With random poses all conditions
// are unpredictable, so both sides are computed, and masks select.
#pragma once

#include <numbers>

#include "controller/base/lanes.hpp"
#include "controller/kinematics/branch_choice.hpp"
#include "controller/kinematics/turns.hpp"

namespace armature {

[[nodiscard]] inline math::Lanes larger(math::Lanes a, math::Lanes b) noexcept {
  return math::select(a < b, b, a);
}

// nearest_turn() of both; within 1e9 turns.
[[nodiscard]] inline math::Lanes nearest_turns(math::Lanes angle_rad, double reference_rad) noexcept {
  const math::Lanes turns = (reference_rad - angle_rad) / kTurn_rad + 0.5;
  const math::Lanes integer = (turns + math::kToInteger) - math::kToInteger;
  const math::Lanes whole = integer - math::masked(math::all_lanes(1.0), integer > turns);
  const math::Masks near = math::magnitude(angle_rad - reference_rad) <= std::numbers::pi;
  return math::select(near, angle_rad, angle_rad + kTurn_rad * whole);
}

// limit_excess() of both, without setting a joint to its limit.
[[nodiscard]] inline math::Lanes limit_excesses(math::Lanes joint_rad, const JointRange& range) noexcept {
  const math::Lanes excess_rad = larger(joint_rad - range.max_rad, range.min_rad - joint_rad);
  return math::masked(excess_rad, excess_rad > kLimitTolerance_rad);
}

struct TurnedJoints {
  math::Lanes joint_rad;
  math::Lanes excess_rad;  // 0: inside its limits
};

// limit_excess() after turned_inside(), for both.
[[nodiscard]] inline TurnedJoints turn_inside(math::Lanes nearest, const JointRange& range) noexcept {
  using math::Lanes;
  const Lanes beyond_max = nearest - range.max_rad, beyond_min = range.min_rad - nearest;
  const Lanes beyond = larger(beyond_max, beyond_min);
  const math::Masks over = (nearest > range.max_rad + kLimitTolerance_rad) & (beyond_max > kLimitTolerance_rad);
  const math::Masks under = (nearest < range.min_rad - kLimitTolerance_rad) & (beyond_min > kLimitTolerance_rad);
  if (!math::both(beyond - kLimitTolerance_rad <= kTurn_rad)) [[unlikely]] {  // more than one turn
    TurnedJoints turned{};
    for (std::size_t lane = 0; lane < 2; ++lane) {
      double joint_rad = turned_inside(nearest[lane], range);
      turned.excess_rad[lane] = limit_excess(joint_rad, range);
      turned.joint_rad[lane] = joint_rad;
    }
    return turned;
  }
  const Lanes turn = math::masked(math::all_lanes(kTurn_rad), over) - math::masked(math::all_lanes(kTurn_rad), under);
  const Lanes back = nearest - turn, forth = back + turn;
  const Lanes excess_back = limit_excesses(back, range), excess_forth = limit_excesses(forth, range);
  const math::Masks outside = over | under, take_back = excess_back <= excess_forth;
  const Lanes joint = math::select(outside, math::select(take_back, back, forth), nearest);
  const Lanes excess = math::select(outside, math::select(take_back, excess_back, excess_forth),
                                    math::masked(beyond, beyond > kLimitTolerance_rad));
  const Lanes low = larger(joint, math::all_lanes(range.min_rad));
  const Lanes clamped = math::select(low > range.max_rad, math::all_lanes(range.max_rad), low);
  return {math::select(excess == 0.0, clamped, joint), excess};
}

[[nodiscard]] inline math::Masks inside(math::Lanes joint_rad, const JointRange& range) noexcept {
  return (joint_rad >= range.min_rad) & (joint_rad <= range.max_rad);
}

[[nodiscard]] inline math::Lanes move_times_s(math::Lanes joint_rad, double previous_rad, double speed_rad_s) noexcept {
  return math::magnitude(joint_rad - previous_rad) / speed_rad_s;
}

}  // namespace armature
