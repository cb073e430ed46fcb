// The tool centre point, computed from joint angles.
#pragma once

#include <array>

#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/message/telemetry.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/trace/columns.hpp"
#include "cosim/trace/trace_row.hpp"

namespace armature::cosim {

// Whether traces of this scenario have the columns of the tool centre point. [trace] tcp decides. Without this key they
// have them if a move is given as a pose.
[[nodiscard]] ToolColumns tool_columns(const Scenario& scenario);

// Whether a trace, a report or a key of [expect] needs the tool centre point.
[[nodiscard]] bool needs_tool_point(const Scenario& scenario);

// Roll, pitch and yaw of a rotation [deg], about the fixed axes x, then y, then z.
[[nodiscard]] std::array<double, 3> rpy_deg(const Eigen::Matrix3d& rotation);

class ToolPointMeter {
 public:
  // The robot must have kinematics.
  explicit ToolPointMeter(const Scenario& scenario);

  [[nodiscard]] ToolPoint measure(const Telemetry& telemetry) const;
  [[nodiscard]] Eigen::Vector3d set_point_mm(const Telemetry& telemetry) const;

 private:
  Arm arm_;
  Transform flange_T_tool_;
};

}  // namespace armature::cosim
