#include "controller/trajectory/plan/path_joint_corner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "controller/base/timebase.hpp"
#include "controller/robot/axis_units.hpp"
#include "controller/trajectory/joint/corner_search.hpp"
#include "controller/trajectory/joint/joint_chain.hpp"

namespace armature {
namespace {

// A part of a path that is shorter than this has no corner.
constexpr std::int64_t kLeastTicks = 16;
// Points of the end of a path and of the joint move that are compared.
constexpr std::int64_t kPathPoints = 32, kMovePoints = 24;
// Inverse kinematics of one call of approach() or prepare().
constexpr std::int64_t kPiece = 50;

// A pose of the tool as a point: the distance of two points is that of the positions and of the rotation, which counts
// as a chord at kTurnLever_mm.
using PosePoint = Eigen::Matrix<double, 12, 1>;
using JointPoint = Eigen::Matrix<double, static_cast<int>(kAxes), 1>;

PosePoint point_of(const Transform& base_T_tool) {
  PosePoint point;
  point.head<3>() = base_T_tool.position_mm;
  const double lever_mm = kTurnLever_mm * std::sqrt(0.5);
  for (int column = 0; column < 3; ++column) {
    point.segment<3>(3 + 3 * column) = lever_mm * base_T_tool.rotation.col(column);
  }
  return point;
}

JointPoint point_of(const JointAngles& joints) {
  JointPoint point;
  for (std::size_t axis = 0; axis < kAxes; ++axis) point(static_cast<Eigen::Index>(axis)) = joints[axis].value();
  return point;
}

double size_of(const PosePoint& difference) {
  return difference.norm();
}
double size_of(const JointPoint& difference) {
  return difference.cwiseAbs().maxCoeff();
}

// The distance of a point from points of a path in its order, joined by straight lines.
template <class Point>
double distance(std::span<const Point> trace, const Point& point) {
  double least = size_of(Point{point - trace[0]});
  for (std::size_t i = 1; i < trace.size(); ++i) {
    const Point way = trace[i] - trace[i - 1], from = point - trace[i - 1];
    const double square = way.squaredNorm();
    const double share = square > 0.0 ? std::clamp(from.dot(way) / square, 0.0, 1.0) : 0.0;
    least = std::min(least, size_of(Point{from - share * way}));
  }
  return least;
}

// The motion of an axis by the differences of its set-points: position, and its derivatives in ticks.
struct TickMotion {
  double position = 0.0, speed = 0.0, accel = 0.0, jerk = 0.0;

  void add(double next) noexcept {
    const double next_speed = next - position, next_accel = next_speed - speed;
    jerk = next_accel - accel;
    accel = next_accel;
    speed = next_speed;
    position = next;
  }

  // `before`: the set-points before the last one. Each difference needs one more.
  [[nodiscard]] bool keeps_limits(const AxisModel& model, bool with_jerk, int before) const noexcept {
    constexpr double kLimitRounding = 1e-6, kJerkRounding = 1e-3;
    constexpr double kTick2 = kTickSeconds * kTickSeconds;
    const auto exceeds = [](double size, double limit, double rounding) {
      return !(std::fabs(size) <= limit * (1.0 + rounding));
    };
    if (before > 0 && exceeds(speed, AxisUnits{model}.max_speed_rad_s() * kTickSeconds, kLimitRounding)) return false;
    if (before > 1 && exceeds(accel, model.max_accel_rad_s2 * kTick2, kLimitRounding)) return false;
    return !(with_jerk && before > 2 && exceeds(jerk, model.max_jerk_rad_s3 * kTick2 * kTickSeconds, kJerkRounding));
  }
};

// Differences of set-points across the change between a path and a joint move, at ticks and at quarters of them: a hold
// or an override moves the set-points between ticks. `joints_at(ticks)`: relative to the change.
template <class JointsAt>
bool keeps_limits(const RobotModel& robot, bool with_jerk, JointsAt joints_at) {
  constexpr int kParts = 4, kOrders = 3;
  for (int part = 0; part < kParts; ++part) {
    PerAxis<TickMotion> motion{};
    for (int k = -kOrders; k < kOrders; ++k) {
      const JointAngles joints = joints_at(k + static_cast<double>(part) / kParts);
      for (std::size_t axis = 0; axis < robot.axis_count; ++axis) {
        motion[axis].add(joints[axis].value());
        if (!motion[axis].keeps_limits(robot.axes[axis], with_jerk, k + kOrders)) return false;
      }
    }
  }
  return true;
}

bool has_jerk_limit(const RetargetPlan& plan, const CartesianSegment& segment) {
  return plan.kind == ProfileKind::kSCurve && segment.profile == ProfileKind::kSCurve;
}

}  // namespace

PathExit::PathExit(const RobotModel& robot, const Arm& arm, const CartesianPlan& path, Ticks from,
                   double blend_mm) noexcept
    : robot_{robot},
      arm_{arm},
      cursor_{robot, arm, path, PathCursor::Place::kEnd},
      blend_mm_{blend_mm},
      early_{path.duration.value()} {
  const CartesianSegment& last = path.segments[path.count - 1];
  const std::int64_t middle = last.start.value() + (last.duration.value() + 1) / 2;
  if (blend_mm > 0.0 && last.duration.value() >= 2 * kLeastTicks) {
    early_ = std::max(middle, from.value() + kLeastTicks);
  }
}

bool PathExit::approach(std::int64_t tick) noexcept {
  return cursor_.approach(static_cast<double>(tick), kPiece);
}

bool PathExit::keeps(const RetargetPlan& plan, std::int64_t tick) noexcept {
  const CartesianPlan& path = cursor_.plan();
  if (tick >= end()) return true;
  if (tick > end() - kLeastTicks) return false;
  const Transform flange_T_tool = inverse(path.tool_T_flange);
  const auto tool = [&](const JointAngles& joints) {
    ++forwards_;
    return point_of(arm_.forward(joints) * flange_T_tool);
  };
  const PosePoint corner = point_of(tool_pose(path, seconds(path.duration)));
  const ClosestSetPoint closest =
      closest_set_point(plan, [&](const JointAngles& joints) { return (tool(joints) - corner).norm(); });
  passed_ = Ticks{closest.tick};
  if (closest.distance > blend_mm_) return false;

  std::array<PosePoint, kPathPoints + 1> trace;
  for (std::size_t i = 0; i < trace.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(kPathPoints);
    const double ticks = static_cast<double>(tick) + share * static_cast<double>(end() - tick);
    trace[i] = point_of(tool_pose(path, ticks * kTickSeconds));
  }
  for (std::int64_t i = 1; i < kMovePoints; ++i) {
    const JointAngles joints = position(plan, seconds(Ticks{closest.tick * i / kMovePoints}));
    if (distance<PosePoint>(trace, tool(joints)) > blend_mm_) return false;
  }
  return keeps_limits(robot_, has_jerk_limit(plan, path.segments[path.count - 1]), [&](double ticks) {
    if (ticks >= 0.0) return position(plan, ticks * kTickSeconds);
    return cursor_.joints_at(static_cast<double>(tick) + ticks);
  });
}

PathEntry::PathEntry(const RobotModel& robot, const Arm& arm, const CartesianPlan& path, double blend_rad, double share,
                     double half_way_rad) noexcept
    : robot_{robot},
      cursor_{robot, arm, path, PathCursor::Place::kStart},
      blend_rad_{blend_rad},
      share_{share},
      half_way_rad_{half_way_rad} {
  const std::int64_t first_ticks = path.segments[0].duration.value();
  if (first_ticks >= 2 * kLeastTicks) late_ = first_ticks / 2;
}

bool PathEntry::prepare() noexcept {
  if (late_ == 0) return true;
  const std::int64_t end = cursor_.inverses() + kPiece;
  while (count_ < points_.size()) {
    const auto ticks = static_cast<double>(tick_of(count_));
    if (!cursor_.approach(ticks, end - cursor_.inverses()) || cursor_.inverses() >= end) return false;
    points_[count_++] = cursor_.joints_at(ticks);
  }
  if (blend_rad_ > 0.0) return true;
  double half_rad = 0.0;
  for (const JointAngles& joints : points_) half_rad = std::max(half_rad, largest_difference(joints, points_[0]));
  blend_rad_ = share_ * std::min(half_way_rad_, half_rad);
  return true;
}

bool PathEntry::approach(std::int64_t tick) noexcept {
  return cursor_.approach(static_cast<double>(tick), kPiece);
}

bool PathEntry::keeps(const RetargetPlan& plan, std::int64_t tick) noexcept {
  const CartesianPlan& path = cursor_.plan();
  if (tick <= 0) return true;
  if (tick < kLeastTicks) return false;
  const ClosestSetPoint closest = closest_to(path.start, plan);
  if (closest.distance > blend_rad_) return false;

  std::array<JointPoint, kPoints + 1> trace;
  std::size_t count = 0;
  for (; tick_of(count) < tick; ++count) trace[count] = point_of(points_[count]);
  trace[count++] = point_of(cursor_.joints_at(static_cast<double>(tick)));
  const std::int64_t left = plan.duration.value() - closest.tick;
  for (std::int64_t i = 1; i < kMovePoints; ++i) {
    const JointAngles joints = position(plan, seconds(Ticks{closest.tick + left * i / kMovePoints}));
    if (distance<JointPoint>({trace.data(), count}, point_of(joints)) > blend_rad_) return false;
  }
  return keeps_limits(robot_, has_jerk_limit(plan, path.segments[0]), [&](double ticks) {
    if (ticks < 0.0) return position(plan, seconds(plan.duration) + ticks * kTickSeconds);
    return cursor_.joints_at(static_cast<double>(tick) + ticks);
  });
}

}  // namespace armature
