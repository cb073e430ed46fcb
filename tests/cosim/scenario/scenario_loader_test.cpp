// The tables of a scenario file but moves to poses and expectations.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cosim/scenario/files/scenario_loader.hpp"
#include "tests/cosim/support/scenario_files.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

using test::shipped;
using test::TempFolder;
using testing::ElementsAre;

constexpr const char* kEveryKey = R"(
description = "every key"
robot = "vo2021_6r"
duration_s = 2
seed = 42
[controller]
sync = "time_scale"
feedback = false
max_stretch = 50
[kinematics]
solver = "cordic"
[cpu]
interrupt_entry_cycles = 1
tick_compute_cycles = 2
plan_compute_cycles = 3
retarget_compute_cycles = 4
corner_compute_cycles = 5
window_compute_cycles = 6
inverse_compute_cycles = 7
program_step_compute_cycles = 8
network_compute_cycles = 9
[bus]
latency_cycles = 4
timeout_cycles = 500
stall_probability = 0.25
[trace]
every_ticks = 7
tcp = false
[[move]]
at_s = 1.5
type = "stop"
[[move]]
at_s = 0.5
type = "joint"
target_deg = [1, -2, 3.5, 4, 5, 6]
speed_percent = 50
[[move]]
at_s = 1.75
type = "clear_fault"
[[fault]]
at_s = 1.0
kind = "estop"
duration_s = 0.125
[[fault]]
at_s = 0.25
kind = "pulse_loss"
axis = 3
count = 500
[[fault]]
at_s = 1.25
kind = "slow_core"
compute_us = 300
[golden]
sha256 = "0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef"
)";

TEST(ScenarioLoader, ReadsEveryTableButMovesToPosesAndExpectations) {
  const TempFolder folder;
  const Scenario s = load_scenario(folder.write("all_keys/scenario.toml", kEveryKey), shipped());
  EXPECT_EQ(s.name, "all_keys");
  EXPECT_EQ(s.directory, (folder.path() / "all_keys").string());
  EXPECT_EQ(s.description, "every key");
  EXPECT_EQ(s.robot_name, "vo2021_6r");
  EXPECT_EQ(s.robot.name, "vo2021_6r");
  EXPECT_EQ(s.duration_s, 2.0);
  EXPECT_EQ(s.seed, 42u);
  EXPECT_EQ(s.controller.sync, "time_scale");
  EXPECT_FALSE(s.controller.feedback);
  const std::vector works{Work::kInterruptEntry, Work::kTick,    Work::kPlan,        Work::kRetarget, Work::kCorner,
                          Work::kWindow,         Work::kInverse, Work::kProgramStep, Work::kNetwork};
  ASSERT_EQ(works.size(), kWorks);
  for (std::size_t i = 0; i < kWorks; ++i)
    EXPECT_EQ(cycles_of(s.cpu, works[i]), static_cast<std::int64_t>(i + 1)) << "work " << i;
  EXPECT_EQ(s.bus.latency_cycles, 4);
  EXPECT_EQ(s.bus.timeout_cycles, 500);
  EXPECT_EQ(s.bus.stall_probability, 0.25);
  EXPECT_EQ(s.trace.every_ticks, 7);
  EXPECT_EQ(s.trace.tcp, false);
  EXPECT_EQ(s.controller.max_stretch, 50);
  EXPECT_EQ(s.kinematics.solver, SetPointSolver::kCordic);

  ASSERT_EQ(s.moves.size(), 3u);
  const auto& joint = std::get<JointSpec>(s.moves[0].kind);
  EXPECT_EQ(s.moves[0].at_s, 0.5);
  EXPECT_THAT(joint.target_deg.value(), ElementsAre(1, -2, 3.5, 4, 5, 6));
  EXPECT_EQ(joint.speed_percent, 50);
  EXPECT_EQ(s.moves[0].line, 32);
  EXPECT_TRUE(std::holds_alternative<StopSpec>(s.moves[1].kind));
  EXPECT_TRUE(std::holds_alternative<ClearFaultSpec>(s.moves[2].kind));

  ASSERT_EQ(s.faults.size(), 3u);
  EXPECT_EQ(s.faults[0].kind, FaultKind(PulseLoss{.axis = 3, .count = 500}));
  EXPECT_EQ(s.faults[1].kind, FaultKind(Estop{.duration_s = 0.125}));
  EXPECT_EQ(s.faults[2].kind, FaultKind(SlowCore{.compute_us = 300}));

  EXPECT_EQ(s.golden.sha256->substr(0, 4), "0123");
}

TEST(ScenarioLoader, KeepsTheDefaultsOfWhatIsNotWritten) {
  const TempFolder folder;
  const Scenario s = load_scenario(
      folder.write("x/scenario.toml", "description = \"d\"\nrobot = \"vo2021_6r\"\nduration_s = 1\n"), shipped());
  EXPECT_EQ(s.seed, 1u);
  EXPECT_EQ(s.controller.sync, "fig9");
  EXPECT_TRUE(s.controller.feedback);
  EXPECT_EQ(s.trace.every_ticks, 20);
  EXPECT_TRUE(s.moves.empty());
  EXPECT_EQ(s.expect.outcome, std::nullopt);
  EXPECT_EQ(s.golden.sha256, std::nullopt);
}

}  // namespace
}  // namespace armature::cosim
