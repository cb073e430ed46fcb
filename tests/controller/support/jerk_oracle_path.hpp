// A path as the oracle of jerk_oracle.hpp sees it: poses at places of a planned path, limits, and samples of a motion.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>

#include "controller/base/timebase.hpp"
#include "controller/robot/axis_units.hpp"
#include "tests/controller/support/jerk_oracle.hpp"

namespace armature::test::jerk_oracle {

using Vector = Eigen::Vector3d;

// The joints and the tool at a place; the rotation as a vector that is summed up along the path.
struct Pose {
  JointAngles joints{};
  Vector move = Vector::Zero(), turn = Vector::Zero();
  ToolSample tool{};
};

// A limited quantity: a joint, the position or the rotation.
struct Limit {
  double speed, accel, jerk;
};
constexpr std::size_t kQuantities = kAxes + 2;
constexpr double kNone = 1e30;

inline Vector of(const Pose& pose, std::size_t quantity) {
  if (quantity < kAxes) return {pose.joints[quantity].value(), 0.0, 0.0};
  return quantity == kAxes ? pose.move : pose.turn;
}

class Path {
 public:
  Path(const PathRig& rig, const CartesianSegment& segment) : rig_{rig} {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const AxisModel& model = rig.robot.axes[axis];
      const bool used = axis < rig.robot.axis_count;
      limits_[axis] = used ? Limit{AxisUnits{model}.max_speed_rad_s(), model.max_accel_rad_s2, model.max_jerk_rad_s3}
                           : Limit{kNone, kNone, kNone};
    }
    const PathLimits& most = segment.limits;
    limits_[kAxes] = {most.speed_mm_s, most.accel_mm_s2, most.jerk_mm_s3};
    limits_[kAxes + 1] = {most.turn_speed_rad_s, most.turn_accel_rad_s2, most.turn_jerk_rad_s3};
  }

  [[nodiscard]] const Limit& limit(std::size_t quantity) const { return limits_[quantity]; }

  [[nodiscard]] Pose first(double s, const JointAngles& joints) const {
    Pose pose{.joints = joints, .tool = tool_on_path(rig_.planner.plan(), s)};
    pose.move = pose.tool.tool.base_T_tool.position_mm;
    return pose;
  }
  [[nodiscard]] Pose next(double s, const Pose& before) const {
    Pose pose = first(s, joints_on_path(rig_.planner.plan(), rig_.arm, s, before.joints).joints);
    pose.turn = before.turn + limited_turn(before.tool, pose.tool);
    return pose;
  }

 private:
  const PathRig& rig_;
  std::array<Limit, kQuantities> limits_{};
};

// The last samples of a motion, one every tick, and the shares of the limits that their differences use.
class Samples {
 public:
  Samples(const Path& path, const Pose& first) : path_{path} { at_.fill(first); }

  // Returns those of this sample.
  SampledShares add(double s) {
    at_ = {path_.next(s, at_[0]), at_[0], at_[1], at_[2]};
    SampledShares now;
    for (std::size_t i = 0; i < kQuantities; ++i) {
      const Limit& limit = path_.limit(i);
      const auto step = [&](std::size_t back) -> Vector { return of(at_[back], i) - of(at_[back + 1], i); };
      const auto grow = [](double& most, const Vector& change, double limited, double times) {
        most = std::max(most, change.norm() / (limited * times));
      };
      constexpr double kTick2 = kTickSeconds * kTickSeconds;
      grow(now.speed, step(0), limit.speed, kTickSeconds);
      grow(now.accel, step(0) - step(1), limit.accel, kTick2);
      grow(now.jerk, step(0) - 2.0 * step(1) + step(2), limit.jerk, kTick2 * kTickSeconds);
    }
    most_ = {std::max(most_.speed, now.speed), std::max(most_.accel, now.accel), std::max(most_.jerk, now.jerk)};
    return now;
  }
  [[nodiscard]] const SampledShares& most() const { return most_; }

 private:
  const Path& path_;
  std::array<Pose, 4> at_;
  SampledShares most_{};
};

}  // namespace armature::test::jerk_oracle
