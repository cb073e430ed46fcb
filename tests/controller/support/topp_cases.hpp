// Paths whose time is compared with the shortest time that the path and the limits permit, and these limits: from the
// poses of the path, the inverse kinematics and the requested limits.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "controller/robot/axis_units.hpp"
#include "controller/trajectory/cartesian/path_corners.hpp"
#include "tests/controller/support/law_oracle.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature::test {

inline constexpr PathLimits kFast{.speed_mm_s = 1'000.0,
                                  .accel_mm_s2 = 10'000.0,
                                  .jerk_mm_s3 = 1e6,
                                  .turn_speed_rad_s = 10.0,
                                  .turn_accel_rad_s2 = 100.0,
                                  .turn_jerk_rad_s3 = 1e4};

// The jerk of the tool point at a right angle to the path at `count` + 1 equally spaced points of the planned path.
// Derivatives are differences.
inline std::vector<JerkAcross> jerk_across(const PathRig& rig, double most_mm_s3, int count) {
  const CartesianPlan& plan = rig.planner.plan();
  const double h = length_of(plan) / count;
  std::vector<Eigen::Vector3d> places;
  for (int i = 0; i <= count; ++i) places.push_back(tool_on_path(plan, h * i).tool.base_T_tool.position_mm);
  std::vector<JerkAcross> result(places.size());
  for (std::size_t k = 2; k + 2 < places.size(); ++k) {
    const Eigen::Vector3d tangent = (places[k + 1] - places[k - 1]).normalized();
    const auto across = [&](const Eigen::Vector3d& v) -> Eigen::Vector3d { return v - v.dot(tangent) * tangent; };
    const Eigen::Vector3d bend = across(places[k + 1] - 2.0 * places[k] + places[k - 1]) / (h * h);
    const Eigen::Vector3d jolt =
        across(places[k + 2] - 2.0 * places[k + 1] + 2.0 * places[k - 1] - places[k - 2]) / (2.0 * h * h * h);
    const Eigen::Vector3d both = 3.0 * bend / most_mm_s3, speed = jolt / most_mm_s3;
    result[k] = {both.squaredNorm(), both.dot(speed), speed.squaredNorm()};
  }
  return result;
}

// Limits at `count` + 1 equally spaced points of the planned path, without any margin. Derivatives are differences.
inline std::vector<LawLimits> limits_along(const PathRig& rig, const PathLimits& most, int count) {
  const CartesianPlan& plan = rig.planner.plan();
  const double length = length_of(plan), h = length / count;
  std::vector<JointAngles> joints{plan.start};
  std::vector<Eigen::Vector3d> places;
  std::vector<Eigen::Matrix3d> rotations;
  for (int i = 0; i <= count; ++i) {
    const Transform pose = tool_on_path(plan, h * i).tool.base_T_tool;
    places.push_back(pose.position_mm);
    rotations.push_back(pose.rotation);
    if (i > 0) joints.push_back(rig.arm.track(pose * inverse(rig.flange_T_tool), joints.back()).joints);
  }
  std::vector<LawLimits> result;
  for (int i = 0; i <= count; ++i) {
    const auto k = static_cast<std::size_t>(std::clamp(i, 1, count - 1));
    LawLimits limits;
    double speed = 1e30;
    const auto at_most = [&](double rate, double limit) {
      if (rate > 0.0) speed = std::min(speed, limit / rate);
    };
    for (std::size_t axis = 0; axis < rig.robot.axis_count; ++axis) {
      const double a = joints[k - 1][axis].value(), b = joints[k][axis].value(), c = joints[k + 1][axis].value();
      const AxisModel& model = rig.robot.axes[axis];
      limits.bands[axis] = {(c - a) / (2.0 * h) / model.max_accel_rad_s2,
                            (a - 2.0 * b + c) / (h * h) / model.max_accel_rad_s2};
      at_most(std::fabs(c - a) / (2.0 * h), AxisUnits{model}.max_speed_rad_s());
    }
    const auto ellipse = [](const Eigen::Vector3d& slope, const Eigen::Vector3d& bend, double limit) {
      return LawLimits::Ellipse{slope.squaredNorm() / (limit * limit), slope.dot(bend) / (limit * limit),
                                bend.squaredNorm() / (limit * limit)};
    };
    const Eigen::Vector3d slope = (places[k + 1] - places[k - 1]) / (2.0 * h);
    const Eigen::Vector3d bend = (places[k + 1] - 2.0 * places[k] + places[k - 1]) / (h * h);
    const auto turn = [&](std::size_t from, std::size_t to) -> Eigen::Vector3d {
      const Eigen::Matrix3d m = rotations[to] * rotations[from].transpose();
      return 0.5 * Eigen::Vector3d{m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)};
    };
    const Eigen::Vector3d before = turn(k - 1, k), after = turn(k, k + 1);
    limits.ellipses = {ellipse(slope, bend, most.accel_mm_s2),
                       ellipse((before + after) / (2.0 * h), (after - before) / (h * h), most.turn_accel_rad_s2)};
    at_most(slope.norm(), most.speed_mm_s);
    at_most(((before + after) / (2.0 * h)).norm(), most.turn_speed_rad_s);
    limits.most_square = speed * speed;
    result.push_back(limits);
  }
  return result;
}

// The shortest time that the planned path permits with the jerk across it, but without that along it.
inline double bound_with_jerk_s(const PathRig& rig, const PathLimits& limits, int count) {
  const double step = length_of(rig.planner.plan()) / count;
  return static_cast<double>(
      least_duration_s(limits_along(rig, limits, count), step, jerk_across(rig, limits.jerk_mm_s3, count)));
}

struct ToppCase {
  std::string name;
  RobotModel robot;
  JointAngles start;
  std::vector<SegmentRequest> chain;
  int count = 20'000;  // points of the bound
};

inline std::vector<ToppCase> topp_cases() {
  std::vector<ToppCase> cases;
  RobotModel turning = irb120();  // wrist joints that can turn more than once
  turning.axes[3].min_rad = turning.axes[5].min_rad = -7.0, turning.axes[3].max_rad = turning.axes[5].max_rad = 7.0;
  const PathRig rig{irb120()};
  const Transform ready = rig.tool_at(kReady);
  for (const double miss_mm : {2.0, 4.0, 10.0}) {
    cases.push_back({"axis 1 at " + std::to_string(miss_mm),
                     turning,
                     joints_at(rig, down_from(rig, miss_mm, -150, 650)),
                     {line_to(down_from(rig, miss_mm, 150, 650), kFast)},
                     40'000});
  }
  const double reach = 270.0 + std::hypot(70.0, 302.0);
  cases.push_back({"end near the reach",
                   irb120(),
                   joints_at(rig, down_from(rig, 400, 0, 290)),
                   {line_to(down_from(rig, reach - 0.3, 0, 290), kFast)},
                   40'000});
  PathLimits joints_limit = kFast;
  joints_limit.speed_mm_s = 5'000.0, joints_limit.accel_mm_s2 = 1e5, joints_limit.jerk_mm_s3 = 1e7;
  cases.push_back({"circle where joints limit",
                   irb120(),
                   kReady,
                   {circle_through(moved(ready, 100, 100, 0).position_mm, moved(ready, 0, 200, 0), joints_limit)}});
  ToppCase ten{"ten collinear lines", irb120(), kReady, {}};
  for (int i = 1; i <= 10; ++i) ten.chain.push_back(line_to(moved(ready, 0, 5.0 * i, 0), kFast, 0.05));
  cases.push_back(ten);
  for (const double blend_mm : {0.1, 1.0, 5.0}) {
    cases.push_back(
        {"square with blends of " + std::to_string(blend_mm),
         irb120(),
         kReady,
         {line_to(moved(ready, 0, 60, 0), kFast, blend_mm), line_to(moved(ready, -60, 60, 0), kFast, blend_mm),
          line_to(moved(ready, -60, 0, 0), kFast, blend_mm), line_to(ready, kFast)},
         40'000});
  }
  const JointAngles wrist = degrees({0, 10, -20, 0, -20, 0});
  cases.push_back(
      {"through the wrist", irb120(), wrist, {line_to(turned_by(rig.tool_at(wrist), 40.0 * kDeg, {0, 1, 0}), kFast)}});
  return cases;
}

inline std::vector<SegmentRequest> line_arc_line(double blend_mm) {
  const Transform a = PathRig{irb120()}.tool_at(kReady);
  const Transform b = moved(a, 0, 60, 0), c = moved(b, -80, 0, 0), d = moved(a, -80, 0, 0);
  return {line_to(b, kFast, blend_mm), arc_to(moved(b, -40, 40, 0).position_mm, c, kFast, blend_mm), line_to(d, kFast)};
}

inline std::vector<SegmentRequest> fourteen_lines() {
  std::vector<SegmentRequest> chain;
  Transform at = PathRig{irb120()}.tool_at(kReady);
  for (int i = 0; i < 14; ++i) {
    at = moved(at, std::sin(0.1 * i), std::cos(0.1 * i), 0);
    chain.push_back(line_to(at, kFast, 0.05));
  }
  return chain;
}

}  // namespace armature::test
