// Runs of a controller with corners between paths of the tool and joint moves, and an oracle that judges them by their
// set-points: limits, stops and deviations.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "controller/base/timebase.hpp"
#include "controller/robot/axis_units.hpp"
#include "tests/controller/support/cartesian_moves.hpp"

namespace armature::test {

inline constexpr std::int64_t kTripSecond = 20'000;

inline PathLimits path_limits(double speed_mm_s, double accel_mm_s2) {
  return {.speed_mm_s = speed_mm_s,
          .accel_mm_s2 = accel_mm_s2,
          .jerk_mm_s3 = 20 * accel_mm_s2,
          .turn_speed_rad_s = 3,
          .turn_accel_rad_s2 = 30,
          .turn_jerk_rad_s3 = 1'000};
}

inline ControllerConfig with_tool() {
  ControllerConfig config;
  config.flange_T_tool = kTool;
  return config;
}

inline CartesianMove line(const Eigen::Vector3d& way_mm, double blend_mm, std::uint32_t tag) {
  return {.target = {.frame = kToolFrame, .position_mm = way_mm},
          .limits = path_limits(400, 4'000),
          .blend_mm = blend_mm,
          .tag = tag};
}

inline PerAxis<double> beside(const PerAxis<double>& change_deg) {
  PerAxis<double> deg = kPostureDeg;
  for (std::size_t axis = 0; axis < kAxes; ++axis) deg[axis] += change_deg[axis];
  return deg;
}

inline JointMove joint(const PerAxis<double>& change_deg, double blend_deg, std::uint32_t tag) {
  return {.target = degrees(beside(change_deg)), .blend = {.rad = blend_deg * kDeg}, .tag = tag};
}

// A controller that stands in the posture and then executes commands that wait together.
struct Trip {
  std::unique_ptr<ControllerRig> rig = std::make_unique<ControllerRig>(test::irb120(), with_tool());
  Arm arm{rig->robot};

  explicit Trip(const std::vector<Command>& commands, std::int64_t ticks = 2 * kTripSecond) : Trip() {
    for (const Command& command : commands) rig->submit_at(kThere, command);
    rig->run(kThere + ticks);
  }
  Trip() { rig->move_at(0, kPostureDeg); }

  // Without the move to the posture.
  [[nodiscard]] std::vector<MoveStarted> moves() const { return {rig->moves.begin() + 1, rig->moves.end()}; }
  [[nodiscard]] std::int64_t started(std::size_t move) const { return rig->moves.at(move + 1).start_tick.value(); }
  [[nodiscard]] std::int64_t ended(std::size_t move) const { return rig->finished.at(move + 1).tick.value(); }
  [[nodiscard]] std::int64_t taken() const { return rig->finished.back().tick.value() - started(0); }
  [[nodiscard]] const JointAngles& joints(std::int64_t tick) const { return rig->row(tick).reference; }
  [[nodiscard]] Transform tool(std::int64_t tick) const { return arm.forward(joints(tick)) * kTool; }
};

// Differences of the set-points of the whole run, as shares of the limits.
inline void expect_limits(const Trip& run, bool with_jerk, const std::string& what) {
  const std::vector<Telemetry>& rows = run.rig->rows;
  const long double step_s = kTickSeconds;
  for (std::size_t k = static_cast<std::size_t>(kThere); k < rows.size(); ++k) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const auto q = [&](std::size_t back) -> long double { return rows[k - back].reference[axis].value(); };
      const AxisModel& model = run.rig->robot.axes[axis];
      const long double speed = AxisUnits{model}.max_speed_rad_s() * step_s;
      ASSERT_LE(std::fabs(q(0) - q(1)), speed * (1 + 1e-5L)) << what << " tick " << k << " axis " << axis;
      ASSERT_LE(std::fabs(q(0) - 2 * q(1) + q(2)), model.max_accel_rad_s2 * step_s * step_s * (1 + 1e-5L))
          << what << " tick " << k << " axis " << axis;
      if (with_jerk) {
        ASSERT_LE(std::fabs(q(0) - 3 * q(1) + 3 * q(2) - q(3)),
                  model.max_jerk_rad_s3 * step_s * step_s * step_s * (1 + 2e-3L) + 8e-15L)
            << what << " tick " << k << " axis " << axis;
      }
      ASSERT_LE(q(0), model.max_rad + 1e-9L) << what;
      ASSERT_GE(q(0), model.min_rad - 1e-9L) << what;
    }
  }
}

// The step of the fastest joint that is slowest, from tick `first` to `last`.
inline double slowest_step(const Trip& run, std::int64_t first, std::int64_t last) {
  double least = std::numeric_limits<double>::infinity();
  for (std::int64_t tick = first; tick <= last; ++tick) {
    double most = 0.0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      most = std::max(most, std::fabs((run.joints(tick)[axis] - run.joints(tick - 1)[axis]).value()));
    }
    least = std::min(least, most);
  }
  return least;
}

inline double joint_distance(const JointAngles& a, const JointAngles& b) {
  double most = 0.0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) most = std::max(most, std::fabs((a[axis] - b[axis]).value()));
  return most;
}

// A rotation counts as a chord at 100 mm.
inline double pose_distance_mm(const Transform& a, double position_mm, const Eigen::Matrix3d& rotation) {
  const double cosine = std::clamp(0.5 * ((a.rotation * rotation.transpose()).trace() - 1.0), -1.0, 1.0);
  return std::hypot(position_mm, 200.0 * std::sqrt(0.5 * (1.0 - cosine)));
}

struct Corner {
  double missed = std::numeric_limits<double>::infinity();  // distance from the corner at the closest set-point
  double left = 0.0;                                        // largest distance from the path on the path's side of that
};

// From a path (move `first`, a line) to a joint move, in mm.
inline Corner exit_of(const Trip& run, std::size_t first) {
  const PositionPath path{run.moves()[first].path};
  const Eigen::Matrix3d rotation = run.tool(run.started(first)).rotation;
  const auto from_end = [&](std::int64_t tick) {
    const Transform tool = run.tool(tick);
    return pose_distance_mm(tool, (tool.position_mm - path.end_mm).norm(), rotation);
  };
  Corner corner;
  std::int64_t closest = 0;
  const std::int64_t change = run.started(first + 1);
  for (std::int64_t tick = change - 1; tick <= run.ended(first + 1); ++tick) {
    if (from_end(tick) >= corner.missed) continue;
    corner.missed = from_end(tick);
    closest = tick;
  }
  for (std::int64_t tick = change - 1; tick <= closest; ++tick) {
    const Transform tool = run.tool(tick);
    const Eigen::Vector3d way = path.end_mm - path.start_mm, from = tool.position_mm - path.start_mm;
    const double share = std::clamp(way.dot(from) / way.squaredNorm(), 0.0, 1.0);
    corner.left = std::max(corner.left, pose_distance_mm(tool, (from - share * way).norm(), rotation));
  }
  return corner;
}

// From a joint move (`first`) to a path, in rad. `stopped`: the same moves with exact stops, for the joints on the
// path.
inline Corner entry_of(const Trip& run, std::size_t first, const Trip& stopped) {
  const std::int64_t path_start = stopped.started(first + 1);
  const JointAngles& corner_joints = stopped.joints(path_start - 1);
  Corner corner;
  std::int64_t closest = 0;
  const std::int64_t change = run.started(first + 1);
  for (std::int64_t tick = run.started(first); tick <= change; ++tick) {
    const double distance = joint_distance(run.joints(tick), corner_joints);
    if (distance >= corner.missed) continue;
    corner.missed = distance;
    closest = tick;
  }
  for (std::int64_t tick = closest; tick <= change; tick += 7) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::int64_t on_path = path_start - 1; on_path <= stopped.ended(first + 1); on_path += 5) {
      nearest = std::min(nearest, joint_distance(run.joints(tick), stopped.joints(on_path)));
    }
    corner.left = std::max(corner.left, nearest);
  }
  return corner;
}

}  // namespace armature::test
