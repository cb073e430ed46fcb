// Commands for the tool's pins, [[input]], and what [expect] says of the outputs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "controller/message/command.hpp"
#include "cosim/kernel/script/script.hpp"
#include "cosim/scenario/to_controller.hpp"
#include "cosim/time/clock.hpp"
#include "tests/cosim/support/expect_failures.hpp"
#include "tests/cosim/support/scenario_files.hpp"

namespace armature::cosim {
namespace {

using test::scenario_with;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(ScenarioPins, CommandsForPinsBecomeCommandsOfTheController) {
  const Scenario scenario = scenario_with(R"(
[[move]]
at_s = 0.1
type = "dout"
pin = 16
level = 1
[[move]]
at_s = 0.1
type = "wait_din"
pin = 2
level = 0
[[move]]
at_s = 0.1
type = "wait_din"
pin = 3
level = 1
timeout_s = 0.3
[[move]]
at_s = 0.1
type = "wait_din"
pin = 3
level = 1
timeout_s = 1e-6
)");
  const auto output = std::get<SetOutput>(to_command(scenario.moves[0]));
  EXPECT_EQ(output.pin, 16);
  EXPECT_TRUE(output.level);
  EXPECT_EQ(output.tag, 0u);
  const auto for_ever = std::get<WaitInput>(to_command(scenario.moves[1]));
  EXPECT_EQ(for_ever.pin, 2);
  EXPECT_FALSE(for_ever.level);
  EXPECT_EQ(for_ever.timeout, Ticks{0});
  EXPECT_EQ(for_ever.tag, 1u);
  EXPECT_EQ(std::get<WaitInput>(to_command(scenario.moves[2])).timeout, Ticks{6'000});
  EXPECT_EQ(std::get<WaitInput>(to_command(scenario.moves[3])).timeout, Ticks{1}) << "never for ever";
}

TEST(ScenarioPins, InputsComeInTheOrderOfTimeAndBeforeMoves) {
  const Scenario scenario = scenario_with(R"(
[[move]]
at_s = 0.2
type = "stop"
[[input]]
at_s = 0.3
pin = 1
level = 0
[[input]]
at_s = 0.2
pin = 1
level = 1
[[input]]
at_s = 0.2
pin = 2
level = 1
)");
  Script script{scenario};
  EXPECT_EQ(script.next_event(), to_cycles(0.2));
  EXPECT_EQ(std::get<InputSpec>(*script.pop_due(to_cycles(1))).pin, 1);
  EXPECT_EQ(std::get<InputSpec>(*script.pop_due(to_cycles(1))).pin, 2);
  EXPECT_TRUE(std::holds_alternative<CommandSpec>(*script.pop_due(to_cycles(1))));
  EXPECT_FALSE(std::get<InputSpec>(*script.pop_due(to_cycles(1))).level);
}

std::vector<std::string> failures(const std::string& expect_table, const std::vector<OutputChange>& outputs) {
  RunFacts facts;
  facts.outputs = outputs;
  return test::failures(scenario_with("[expect]\n" + expect_table).expect, facts);
}

OutputChange change(int pin, bool level, double at_s) {
  return {.pin = pin, .level = level, .at = to_cycles(at_s)};
}

constexpr const char* kOnAndOff = R"(
[[expect.output]]
at_s = 0.1
pin = 4
level = 1
[[expect.output]]
at_s = 0.2
pin = 4
level = 0
)";

TEST(ScenarioPins, ExpectsAllChangesOfOutputsWithinATick) {
  EXPECT_THAT(failures(kOnAndOff, {change(4, true, 0.10005), change(4, false, 0.19995)}), IsEmpty());
  EXPECT_THAT(failures(kOnAndOff, {change(4, true, 0.10005002), change(4, false, 0.2)}),
              ElementsAre("expect.output: expected pin 4 = 1 at 0.100000 s, pin 4 = 0 at 0.200000 s, each +-50 us, got "
                          "pin 4 = 1 at 0.100050 s, pin 4 = 0 at 0.200000 s"));
  EXPECT_EQ(failures(kOnAndOff, {change(4, true, 0.1)}).size(), 1u) << "one is missing";
  EXPECT_EQ(failures(kOnAndOff, {}).size(), 1u);
  EXPECT_EQ(failures(kOnAndOff, {change(4, true, 0.1), change(4, false, 0.2), change(5, true, 0.3)}).size(), 1u)
      << "one too many";
  EXPECT_EQ(failures(kOnAndOff, {change(5, true, 0.1), change(4, false, 0.2)}).size(), 1u) << "another pin";
  EXPECT_EQ(failures(kOnAndOff, {change(4, false, 0.1), change(4, false, 0.2)}).size(), 1u) << "another level";
  EXPECT_THAT(failures("underruns = 0", {change(4, true, 0.1)}), IsEmpty()) << "not asked for";
  EXPECT_THAT(failures("output = []", {}), IsEmpty());
  EXPECT_EQ(failures("output = []", {change(4, true, 0.1)}).size(), 1u) << "none may change";
}

TEST(ScenarioPins, ExpectsTheToolAtAPlaceWhenAnOutputChanges) {
  const std::string at_place =
      "[[expect.output]]\nat_s = 0.1\npin = 4\nlevel = 1\ntcp_mm = [1, 2, 3]\ntcp_tolerance_mm = 0.01\n";
  OutputChange there = change(4, true, 0.1);
  EXPECT_EQ(failures(at_place, {there}).size(), 1u) << "not measured";
  there.tool_mm = Eigen::Vector3d{1, 2, 3.0099};
  EXPECT_THAT(failures(at_place, {there}), IsEmpty());
  there.tool_mm = Eigen::Vector3d{1, 2, 3.0101};
  EXPECT_THAT(failures(at_place, {there}),
              ElementsAre("expect.output: expected pin 4 = 1 at 0.100000 s and [1.0000, 2.0000, 3.0000] mm, each +-50 "
                          "us, got pin 4 = 1 at 0.100000 s and [1.0000, 2.0000, 3.0101] mm"));
}

// Between two rows the tool is on the way from the set-point of the first to that of the second.
TEST(ScenarioPins, MeasuresTheToolOfTheSetPointsAtAChange) {
  RunFactsCollector collector{RobotSpec{}, 1};
  for (std::int64_t tick = 0; tick < 3; ++tick) {
    TraceRow row;
    row.tick = tick;
    row.cycle = 2'500 * tick;
    row.tool_point.emplace().reference_mm = Eigen::Vector3d{10.0 * static_cast<double>(tick), 0, 0};
    collector.add(row);
  }
  collector.add(OutputChange{.pin = 1, .level = true, .at = Cycles{5'000 + 250}});
  ASSERT_TRUE(collector.facts().outputs.at(0).tool_mm);
  EXPECT_NEAR(collector.facts().outputs[0].tool_mm->x(), 11.0, 1e-12);
}

TEST(ScenarioPins, ExpectsTheOutputsThatAreHighAtTheEnd) {
  const std::vector<OutputChange> run{change(2, true, 0.1), change(1, true, 0.2), change(3, true, 0.3),
                                      change(2, false, 0.4)};
  EXPECT_THAT(failures("final_outputs = [1, 3]", run), IsEmpty());
  EXPECT_THAT(failures("final_outputs = []", {}), IsEmpty());
  EXPECT_THAT(failures("final_outputs = [1]", run), ElementsAre("expect.final_outputs: expected [1], got [1, 3]"));
  EXPECT_THAT(failures("final_outputs = []", run), ElementsAre("expect.final_outputs: expected [], got [1, 3]"));
}

// A command for a pin that never got its turn must not pass unseen.
TEST(ScenarioPins, ACommandForAPinThatWasNotCarriedOutIsUnfinished) {
  RunFactsCollector collector{RobotSpec{}, 1};
  CommandSpec dout;
  dout.kind = DoutSpec{};
  dout.index = 3;
  collector.add(dout);
  EXPECT_EQ(collector.facts().moves_waiting, 1);
  collector.on_event(IoDone{.tag = 3, .pin = 1, .level = true}, Cycles{0});
  EXPECT_EQ(collector.facts().moves_waiting, 0);
}

}  // namespace
}  // namespace armature::cosim
