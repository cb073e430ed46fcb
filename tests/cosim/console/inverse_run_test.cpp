// A pose that core 1 solves, and its text on the serial line.
#include "cosim/console/inverse_run.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "controller/base/angle_units.hpp"
#include "controller/kinematics/arm.hpp"
#include "cosim/text/input_error.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature::cosim {
namespace {

// The same text by other means.
std::string expected(const RobotModel& robot, const InverseTask& task) {
  const IkSolutions solutions = Arm{robot}.inverse(task.base_T_flange, task.previous);
  std::string text = fmt::format("solutions {} status {} selected {}\r\n", solutions.count,
                                 static_cast<int>(solutions.status), solutions.selected);
  for (std::size_t i = 0; i < solutions.count; ++i) {
    const IkBranch& b = solutions.branches[i];
    text += fmt::format("branch {} shoulder {} elbow {} flip {} singular {} clamped {}", i, int{b.shoulder},
                        int{b.elbow}, int{b.flip}, int{b.singular}, b.clamped ? 1 : 0);
    for (std::size_t axis = 0; axis < robot.axis_count; ++axis) {
      const std::string angle = fmt::format("{:.9f}", b.joints[axis].value() * kDegPerRad);
      text += fmt::format(" angle{}={}", axis + 1, angle == "-0.000000000" ? "0.000000000" : angle);
    }
    text += "\r\n";
  }
  return text;
}

InverseTask task_at(const RobotModel& robot, const JointAngles& joints) {
  return {.base_T_flange = Arm{robot}.forward(joints)};
}

TEST(InverseRun, TheTextOnTheLineIsThatOfAllBranches) {
  const JointAngles joints{Radians{0.3}, Radians{-0.4}, Radians{0.5}, Radians{-0.6}, Radians{0.7}, Radians{}};
  for (const RobotModel& robot : {test::irb120(), test::hu2012(0.001)}) {
    const InverseTask task = task_at(robot, joints);
    const InverseRun run = run_inverse(robot, task, {});
    EXPECT_EQ(run.text, expected(robot, task));
    EXPECT_EQ(std::ranges::count(run.text, '\n'), robot.axis_count == 5 ? 3 : 9);
    EXPECT_EQ(run.instructions, 0) << "the host counts none";
  }
}

TEST(InverseRun, ThePoseOfFigure2IsStretched) {
  constexpr Radians kQuarter{-90 * kRadPerDeg};
  const RobotModel robot = test::hu2012(0.001);
  const InverseTask task = task_at(robot, {Radians{}, kQuarter, Radians{}, kQuarter});
  const InverseRun run = run_inverse(robot, task, {});
  EXPECT_EQ(run.text, expected(robot, task));
  EXPECT_NE(run.text.find("singular 4"), std::string::npos) << run.text;
}

TEST(InverseRun, APoseOutOfReachHasNoBranch) {
  const InverseTask task{.base_T_flange = {.position_mm = {5000, 0, 0}}};
  EXPECT_EQ(run_inverse(test::irb120(), task, {}).text,
            fmt::format("solutions 0 status {} selected -1\r\n", static_cast<int>(IkStatus::kUnreachable)));
}

// A character has ten bits, and the line is the bottleneck.
TEST(InverseRun, TheLineTakesItsTime) {
  const RobotModel robot = test::irb120();
  for (const std::int32_t baud : {9'600, 38'400, 115'200, 781'250}) {
    InverseTask task = task_at(robot, {Radians{}, Radians{0.1}, Radians{0.2}});
    task.baud = baud;
    const InverseRun run = run_inverse(robot, task, {});
    EXPECT_EQ(run.text, expected(robot, task)) << baud;
    const double bits = 10.0 * static_cast<double>(run.text.size() + InverseTask::kEnd.size());
    EXPECT_NEAR(static_cast<double>(run.end.value()) / 50e6, bits / baud, 0.08 * bits / baud) << baud;
  }
}

TEST(InverseRun, WhatCannotBeIsRefused) {
  const RobotModel robot = test::irb120();
  EXPECT_THROW(static_cast<void>(run_inverse(robot, {.baud = 921'600}, {})), std::runtime_error);
  EXPECT_THROW(static_cast<void>(run_inverse(robot, {}, {.processor = CpuKind::kA9})), InputError);
  // The text needs longer than the run may take.
  InverseTask slow = task_at(robot, {Radians{}, Radians{0.1}, Radians{0.2}});
  slow.baud = 300;
  EXPECT_THROW(static_cast<void>(run_inverse(robot, slow, {})), std::runtime_error);
}

}  // namespace
}  // namespace armature::cosim
