// A controller with the IRB 120 and a tool, that goes to a posture from which the tool can move freely.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tests/controller/support/controller_rig.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature::test {

inline const PerAxis<double> kPostureDeg{10, 20, 10, 5, 40, -20};
inline const Transform kTool{.rotation = rotation_from_rpy(0.1, -0.2, 0.3), .position_mm = {5, -3, 80}};
// The posture is reached before, the lines begin after this trigger.
inline constexpr std::int64_t kThere = 8'000;

class CartesianMovesTest : public testing::Test {
 protected:
  CartesianMovesTest() : rig{irb120(), config()}, arm{rig.robot} { rig.move_at(0, kPostureDeg); }

  static ControllerConfig config() {
    ControllerConfig config;
    config.flange_T_tool = kTool;
    config.base_T_user[1] = Transform{.rotation = rotation_from_rpy(0, 0, 0.5), .position_mm = {100, 50, 0}};
    return config;
  }

  [[nodiscard]] Transform tool(const JointAngles& joints) const { return arm.forward(joints) * kTool; }
  [[nodiscard]] Transform posture() const { return tool(degrees(kPostureDeg)); }

  static CartesianMove shift(double x_mm, double y_mm, double z_mm, double blend_mm = 0.0) {
    return {
        .target = {.frame = kToolFrame, .position_mm = {x_mm, y_mm, z_mm}}, .limits = kGentle, .blend_mm = blend_mm};
  }

  [[nodiscard]] std::int64_t emitted() const {
    std::int64_t sum = 0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) sum += std::abs(rig.logic.emitted(axis));
    return sum;
  }

  // Largest distance of the set-points' tool from the polyline of all reported lines.
  [[nodiscard]] double path_error_mm() const {
    double worst = 0.0;
    for (const Telemetry& row : rig.rows) {
      if (row.tick < rig.moves.at(1).start_tick) continue;
      if (rig.moves.back().kind == MoveKind::kJoint && row.tick >= rig.moves.back().start_tick) break;
      const Eigen::Vector3d p = tool(row.reference).position_mm;
      double nearest = 1e9;
      for (const MoveStarted& move : rig.moves) {
        if (move.kind != MoveKind::kLine) continue;
        const Eigen::Vector3d way = move.path.end_mm - move.path.start_mm;
        const double s = std::clamp(way.dot(p - move.path.start_mm) / way.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (p - move.path.start_mm - s * way).norm());
      }
      worst = std::max(worst, nearest);
    }
    return worst;
  }

  ControllerRig rig;
  Arm arm;
};

}  // namespace armature::test
