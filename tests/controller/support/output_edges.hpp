// The edges of the tool's outputs, and where the pulses had brought the tool then.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "controller/robot/axis_units.hpp"
#include "tests/controller/support/cartesian_moves.hpp"

namespace armature::test {

struct Edge {
  std::int64_t trigger = 0;  // the pin has changed within the tick that this trigger began
  int pin = 0;
  bool level = false;
};

class OutputEdgesTest : public CartesianMovesTest {
 protected:
  // Reads pins and pulses at every trigger.
  void watch(std::int64_t triggers) {
    for (std::int64_t k = 0; k < triggers; ++k) {
      rig.at(k, [this, k] {
        const std::uint32_t now = rig.logic.tool_outputs(), changed = now ^ pins_;
        for (int pin = 1; pin <= 16; ++pin) {
          const std::uint32_t bit = 1u << (pin - 1);
          if ((changed & bit) != 0) edges.push_back({k - 1, pin, (now & bit) != 0});
        }
        pins_ = now;
        JointAngles joints{};
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
          const double rad = AxisUnits{rig.robot.axes[axis]}.rad_per_pulse();
          joints[axis] = Radians{rad * static_cast<double>(rig.logic.emitted(axis))};
        }
        tool_mm.push_back(tool(joints).position_mm);
      });
    }
    rig.run(triggers);
  }
  static void add(auto& move, int pin, bool level, PathOutput::From from, PathOutput::Unit unit, double offset) {
    PathOutputs& outputs = move.outputs;
    outputs.list[outputs.count++] = {
        .pin = static_cast<std::uint8_t>(pin), .level = level, .from = from, .unit = unit, .offset = offset};
  }
  // The tool at the edge, by the pulses: within half a tick's travel of `place`, and their resolution.
  void expect_edge_at(const Edge& edge, const Eigen::Vector3d& place, double speed_mm_s) const {
    const double most = 0.5 * speed_mm_s * kTickSeconds + kResolution_mm;
    EXPECT_LT((tool_mm.at(static_cast<std::size_t>(edge.trigger)) - place).norm(), most) << "pin " << edge.pin;
  }
  [[nodiscard]] Eigen::Vector3d at(double x_mm, double y_mm, double z_mm = 0.0) const {
    return posture() * Eigen::Vector3d{x_mm, y_mm, z_mm};
  }
  static CartesianMove fast(double x_mm, double y_mm, double blend_mm = 0.0) {
    CartesianMove move = shift(x_mm, y_mm, 0.0, blend_mm);
    move.limits = kBrisk;
    move.limits.speed_mm_s = kSpeed;
    return move;
  }

  static constexpr double kSpeed = 500.0;          // 0.025 mm in a tick
  static constexpr double kResolution_mm = 0.006;  // of pulses, all axes together
  std::vector<Edge> edges;
  std::vector<Eigen::Vector3d> tool_mm;  // at each trigger

 private:
  std::uint32_t pins_ = 0;
};

}  // namespace armature::test
