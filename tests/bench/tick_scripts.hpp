// The runs of the tick benchmark, and which of their ticks a figure is about.
#pragma once

#include <cstddef>

#include "controller/kinematics/arm.hpp"
#include "controller/trajectory/path/segment_request.hpp"
#include "tests/bench/tick_run.hpp"

namespace armature::bench {

// A joint move to a posture comes first; what is meant begins at this tick.
inline constexpr std::size_t kThere = 5'000;

[[nodiscard]] TickScript idle();
[[nodiscard]] TickScript joint_move();
[[nodiscard]] TickScript joint_scurve();
[[nodiscard]] TickScript line();
[[nodiscard]] TickScript corners();      // a square with rounded corners
[[nodiscard]] TickScript arc();          // S-curve, and the tool turns
[[nodiscard]] TickScript short_lines();  // 1500 lines of 0.3 mm on a circle, in windows
[[nodiscard]] TickScript holds();        // the same arc, held and resumed again and again
[[nodiscard]] TickScript five_axis_line();

// Ticks in which the last move is under way; in which a corner is; in which a hold brakes or a resume speeds up.
[[nodiscard]] bool all(const TickRun& run, std::size_t tick);
[[nodiscard]] bool in_lines(const TickRun& run, std::size_t tick);
[[nodiscard]] bool in_last_move(const TickRun& run, std::size_t tick);
[[nodiscard]] bool in_corners(const TickRun& run, std::size_t tick);
[[nodiscard]] bool on_ramps(const TickRun& run, std::size_t tick);

// The first path of a script as the planner sees it.
struct PathCase {
  RobotModel robot;
  Transform flange_T_tool{};
  JointAngles start{};
  SegmentRequest request{};
};
[[nodiscard]] PathCase path_of(const TickScript& script);

}  // namespace armature::bench
