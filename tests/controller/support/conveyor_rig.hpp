// A controller with the IRB 120 and a belt. The belt and the position of the tool are computed here in long double, by
// the elementary rotations of the arm.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "tests/controller/support/controller_rig.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature::test::conveyor {

using Real = long double;
using Point = std::array<Real, 3>;

inline constexpr Real kTick = 50e-6L;
inline constexpr double kCount_mm = 0.01;
inline constexpr double kTool_mm = 100.0;
inline constexpr std::int64_t kPartTrigger = 2'000;  // 0.1 s
inline constexpr std::int64_t kSecond = 20'000;
inline constexpr double kFrom_mm = 120.0, kTo_mm = 420.0;
inline const Point kSyncPoint{380.0L, -250.0L, 200.0L};  // the belt runs along y

inline Transform pointing_down(double x_mm, double y_mm, double z_mm) {
  return {rotation_from_rpy(std::numbers::pi, 0.0, std::numbers::pi), {x_mm, y_mm, z_mm}};
}

inline ControllerConfig with_conveyor(double max_speed_mm_s = 200.0) {
  ControllerConfig config;
  config.flange_T_tool.position_mm.z() = kTool_mm;
  config.conveyor = {.base_T_part = pointing_down(380, -250, 200),
                     .direction = Eigen::Vector3d::UnitY(),
                     .mm_per_count = kCount_mm,
                     .from_mm = kFrom_mm,
                     .to_mm = kTo_mm,
                     .max_speed_mm_s = max_speed_mm_s,
                     .accel_mm_s2 = 1'500.0};
  return config;
}

// The tool point of the IRB 120.
inline Point tool_point(const PerAxis<Radians>& joints) {
  const auto turn = [&](Point p, std::size_t axis, std::size_t from, std::size_t to) {
    const Real angle = joints[axis].value(), s = std::sin(angle), c = std::cos(angle);
    const Real a = p[from], b = p[to];
    p[from] = c * a - s * b;
    p[to] = s * a + c * b;
    return p;
  };
  Point p{72.0L + kTool_mm, 0.0L, 0.0L};
  p = turn(p, 4, 2, 0);  // about y
  p[0] += 302.0L;
  p = turn(p, 3, 1, 2);  // about x
  p[2] += 70.0L;
  p = turn(p, 2, 2, 0);
  p[2] += 270.0L;
  p = turn(p, 1, 2, 0);
  p[2] += 290.0L;
  return turn(p, 0, 0, 1);  // about z
}

inline Real distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

inline Real distance_to_line(const Point& p, const Point& from, const Point& to) {
  Real along = 0.0L, square = 0.0L;
  for (std::size_t i = 0; i < 3; ++i) {
    along += (p[i] - from[i]) * (to[i] - from[i]);
    square += (to[i] - from[i]) * (to[i] - from[i]);
  }
  const Real share = square > 0.0L ? std::clamp(along / square, 0.0L, 1.0L) : 0.0L;
  Point foot;
  for (std::size_t i = 0; i < 3; ++i) foot[i] = from[i] + share * (to[i] - from[i]);
  return distance(p, foot);
}

// A controller with a belt, whose arm waits above it.
struct ConveyorRig {
  using Belt = std::function<Real(Real)>;  // mm at a time in s

  explicit ConveyorRig(Belt motion, const ControllerConfig& config = with_conveyor(),
                       const RobotModel& robot = irb120())
      : rig{robot, config}, belt{std::move(motion)} {
    rig.on_each_trigger = [this] {
      rig.publish_belt(counts(rig.logic.triggers() - 1));
      if (rig.logic.triggers() < 10 || !rig.refusals.empty()) return;
      while (!program.empty() && rig.submit_program(program.front())) program.pop_front();
    };
    rig.submit_at(5, PoseMove{.target = {.position_mm = {380, -60, 260}, .rotation = pointing_down(0, 0, 0).rotation}});
    part_at(kPartTrigger);
  }

  [[nodiscard]] std::int64_t counts(std::int64_t trigger) const {
    return static_cast<std::int64_t>(std::floor(belt(kTick * static_cast<Real>(trigger)) / kCount_mm));
  }
  void part_at(std::int64_t trigger) { rig.submit_at(trigger, ConveyorPart{.counts = counts(trigger)}); }

  // z is measured downwards from the part.
  [[nodiscard]] static CartesianMove line(FrameId frame, const Eigen::Vector3d& to_mm, Tag tag,
                                          double speed_mm_s = 150.0) {
    return {.target = {.frame = frame, .position_mm = to_mm},
            .limits = {.speed_mm_s = speed_mm_s,
                       .accel_mm_s2 = 2'000.0,
                       .turn_speed_rad_s = 2.0,
                       .turn_accel_rad_s2 = 20.0},
            .tag = tag};
  }
  void line_at(std::int64_t trigger, double z_mm, Tag tag, double speed_mm_s = 150.0) {
    rig.submit_at(trigger, line(kConveyorFrame, {0, 0, z_mm}, tag, speed_mm_s));
  }
  void pick() {
    line_at(10, -40.0, 1u);
    line_at(10, 0.0, 2u);
    rig.submit_at(10, SetOutput{.pin = 1, .level = true, .tag = 3u});
    line_at(10, -60.0, 4u);
  }
  void leave() { rig.submit_at(10, JointMove{.target = degrees({60, 20, 10, 5, 40, -20}), .tag = 5u}); }

  [[nodiscard]] std::int64_t tick_of(PartPhase phase) const {
    for (const PartFollowed& part : rig.parts) {
      if (part.phase == phase) return part.tick.value();
    }
    return -1;
  }
  [[nodiscard]] std::vector<PartEnd> ends() const {
    std::vector<PartEnd> ends;
    for (const PartFollowed& part : rig.parts) {
      if (part.phase == PartPhase::kEnded) ends.push_back(part.end);
    }
    return ends;
  }
  [[nodiscard]] Point on_part(std::int64_t tick) const {
    // A set-point is reached two ticks after the trigger at which it was computed.
    Point p = tool_point(rig.row(tick).reference);
    p[1] -= belt(kTick * static_cast<Real>(tick + 2)) - belt(kTick * static_cast<Real>(kPartTrigger));
    return p;
  }

  // The largest distance of the tool from its lines on the part, from the synchronisation until it leaves.
  [[nodiscard]] double tracking_error_mm(std::int64_t end) const {
    const std::int64_t begin = tick_of(PartPhase::kSynchronised);
    EXPECT_GE(begin, 0);
    Point top = kSyncPoint, bottom = kSyncPoint;
    top[2] += 100.0L;
    Real worst = 0.0L;
    for (std::int64_t tick = begin; tick < end; ++tick) {
      // The first line comes from the side; the others are vertical.
      if (rig.moves.size() < 3 || rig.row(tick).tick < rig.moves[2].start_tick) continue;
      worst = std::max(worst, distance_to_line(on_part(tick), bottom, top));
    }
    return static_cast<double>(worst);
  }

  void expect_limits_kept() const {
    for (std::size_t i = 2; i < rig.rows.size(); ++i) {
      if (rig.rows[i].state == MotionState::kFault || rig.rows[i - 1].state == MotionState::kFault) continue;
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const auto q = [&](std::size_t row) { return static_cast<Real>(rig.rows[row].reference[axis].value()); };
        const AxisModel& model = rig.robot.axes[axis];
        ASSERT_LE(std::fabs(q(i) - q(i - 1)) / kTick, model.max_speed_rad_s * (1 + 2e-6L)) << i << " axis " << axis;
        ASSERT_LE(std::fabs(q(i) - 2 * q(i - 1) + q(i - 2)) / (kTick * kTick), model.max_accel_rad_s2 * (1 + 2e-6L))
            << i << " axis " << axis;
      }
    }
  }

  ControllerRig rig;
  Belt belt;
  std::deque<Command> program;  // of Source::kProgram, submitted as there is room, until one is refused
};

inline Real hundred(Real t_s) {
  return 100.0L * t_s;
}

// 100 mm/s, and from `at_s` on another speed after a ramp.
inline ConveyorRig::Belt changing(Real at_s, Real to_mm_s, Real accel) {
  return [=](Real t_s) {
    if (t_s <= at_s) return 100.0L * t_s;
    const Real ramp_s = std::fabs(to_mm_s - 100.0L) / accel, dt = t_s - at_s;
    const Real a = to_mm_s < 100.0L ? -accel : accel;
    if (dt <= ramp_s) return 100.0L * t_s + 0.5L * a * dt * dt;
    return 100.0L * (at_s + ramp_s) + 0.5L * a * ramp_s * ramp_s + to_mm_s * (dt - ramp_s);
  };
}

}  // namespace armature::test::conveyor
