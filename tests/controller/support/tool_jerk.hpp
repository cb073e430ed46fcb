// The jerk of the tool from its poses at the set-points alone, in long double.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"

namespace armature::test {

// Third differences over ticks, as shares of the limits. `shift`: of the set-points, in ticks. The arm rests before and
// after the plan.
struct ToolJerks {
  long double move = 0.0L, turn = 0.0L;
};

inline ToolJerks tool_jerks(const CartesianPlan& plan, const PathLimits& limits, double shift = 0.0) {
  using Vector = Eigen::Matrix<long double, 3, 1>;
  constexpr long double kTick3 = 50e-6L * 50e-6L * 50e-6L;
  ToolJerks most;
  std::array<Vector, 3> moves, turns;  // the last steps
  moves.fill(Vector::Zero());
  turns.fill(Vector::Zero());
  Transform before = tool_pose(plan, 0.0);
  for (std::int64_t tick = 1; tick <= plan.duration.value() + 4; ++tick) {
    const Transform tool = tool_pose(plan, (static_cast<double>(tick) - shift) * kTickSeconds);
    const Eigen::Matrix3d m = tool.rotation * before.rotation.transpose();
    const Eigen::Vector3d turn = 0.5 * Eigen::Vector3d{m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)};
    const Vector move = tool.position_mm.cast<long double>() - before.position_mm.cast<long double>();
    moves = {move, moves[0], moves[1]};
    turns = {turn.cast<long double>(), turns[0], turns[1]};
    before = tool;
    const auto jerk = [&](const auto& steps) { return (steps[0] - 2.0L * steps[1] + steps[2]).norm() / kTick3; };
    most.move = std::max(most.move, jerk(moves) / static_cast<long double>(limits.jerk_mm_s3));
    most.turn = std::max(most.turn, jerk(turns) / static_cast<long double>(limits.turn_jerk_rad_s3));
  }
  return most;
}

}  // namespace armature::test
