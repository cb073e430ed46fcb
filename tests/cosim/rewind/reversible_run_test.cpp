#include "cosim/rewind/reversible_run.hpp"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "cosim/plant/clock.hpp"
#include "cosim/rewind/run_digest.hpp"
#include "cosim/run/run.hpp"
#include "cosim/time/clock.hpp"
#include "tests/controller/support/draws.hpp"
#include "tests/cosim/run/recorded_run.hpp"
#include "tests/cosim/snapshot/refused_copies.hpp"

namespace armature::cosim {
namespace {

using test::lively_scenario;
using test::RunUnderTest;

constexpr Cycles kEndOfTime{1'000'000'000'000};

Scenario lively_on(Engine engine) {
  Scenario scenario = lively_scenario();
  scenario.engine = engine;
  return scenario;
}

// Every second one is a cycle in which drives and motors compute a step.
std::vector<Cycles> random_cycles(const Scenario& scenario, std::size_t count) {
  std::mt19937_64 random{scenario.seed};
  std::uniform_int_distribution<std::int64_t> cycle{0, to_cycles(scenario.duration_s).value() + 1'000};
  std::vector<Cycles> cycles(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t drawn = cycle(random);
    cycles[i] = Cycles{i % 2 == 0 ? drawn : drawn - drawn % kPlantStep.value()};
  }
  return cycles;
}

// The digests of a plain run of this process, which only goes forwards.
std::map<Cycles, std::string> digests_of_plain_run(const Scenario& scenario, std::vector<Cycles> cycles) {
  std::ranges::sort(cycles);
  RunDigest digest;
  RunUnderTest run{scenario};
  run.add(digest);
  std::map<Cycles, std::string> digests;
  for (const Cycles cycle : cycles) {
    run.advance(cycle);
    digests[cycle] = digest.state(run.look()).digest_text();
  }
  return digests;
}

void expect_same_states(const Scenario& scenario, int draws) {
  const auto points = static_cast<std::size_t>(armature::test::draws(draws));
  const std::vector<Cycles> cycles = random_cycles(scenario, points);
  const std::map<Cycles, std::string> wanted = digests_of_plain_run(scenario, cycles);
  ReversibleRun run{scenario};
  std::size_t backwards = 0;
  for (const Cycles cycle : cycles) {
    if (cycle < run.state().now()) ++backwards;
    ASSERT_EQ(run.go_to(cycle).digest_text(), wanted.at(cycle)) << "cycle " << cycle.value();
  }
  EXPECT_GT(backwards, points / 5);
}

TEST(ReversibleRun, HasTheSameStateFromBothSidesOnTheModel) {
  expect_same_states(lively_on(Engine::kModel), 1'000);
}

TEST(ReversibleRun, HasTheSameStateFromBothSidesOnTheRtl) {
  expect_same_states(lively_on(Engine::kRtl), 40);
}

// Also within a tick that the model would compute as a whole.
TEST(ReversibleRun, HasTheStatesOfTheRtlOnTheModel) {
  const Scenario model = lively_on(Engine::kModel);
  const std::vector<Cycles> cycles = random_cycles(model, static_cast<std::size_t>(armature::test::draws(600)));
  EXPECT_TRUE(digests_of_plain_run(model, cycles) == digests_of_plain_run(lively_on(Engine::kRtl), cycles));
}

TEST(ReversibleRun, HasTheSameStateWhileThePendantTalks) {
  expect_same_states(test::pendant_scenario(), 100);
}

// Otherwise the tests above would compare digests of nothing.
TEST(ReversibleRun, StatesOfTwoScenariosDifferFromTheCycleOnInWhichTheyDiffer) {
  const Scenario first = lively_on(Engine::kModel);
  Scenario second = first;
  second.inputs[0].at_s += to_seconds(Cycles{1});
  const Cycles input = to_cycles(first.inputs[0].at_s);
  ReversibleRun one{first}, other{second};
  EXPECT_EQ(one.go_to(input).digest_text(), other.go_to(input).digest_text());
  EXPECT_NE(one.go_to(input + Cycles{1}).digest_text(), other.go_to(input + Cycles{1}).digest_text());
  EXPECT_NE(one.state().seen.inputs.gpio, other.state().seen.inputs.gpio);
  EXPECT_NE(one.go_to(kEndOfTime).digest_text(), other.go_to(kEndOfTime).digest_text());
}

TEST(ReversibleRun, StepsBackCycleByCycle) {
  const Scenario scenario = lively_on(Engine::kModel);
  ReversibleRun run{scenario};
  std::vector<std::string> forwards;
  for (std::int64_t cycle = 2'000'000; cycle < 2'000'050; ++cycle) {
    forwards.emplace_back(run.go_to(Cycles{cycle}).digest_text());
  }
  while (!forwards.empty()) {
    EXPECT_EQ(run.state().digest_text(), forwards.back());
    forwards.pop_back();
    run.go_to(run.state().now() - Cycles{1});
  }
}

TEST(ReversibleRun, StopsAtATick) {
  ReversibleRun run{lively_on(Engine::kModel)};
  ASSERT_TRUE(run.go_to_tick(400));
  EXPECT_EQ(run.state().seen.triggers, 401);
  const Cycles at = run.state().now();
  const std::string digest{run.state().digest_text()};
  run.go_to(at - Cycles{2});  // before the clock edge of the trigger
  EXPECT_EQ(run.state().seen.triggers, 400);
  ASSERT_TRUE(run.go_to_tick(900));
  EXPECT_EQ(run.state().seen.triggers, 901);
  ASSERT_TRUE(run.go_to_tick(400));
  EXPECT_EQ(run.state().now(), at);
  EXPECT_EQ(run.state().digest_text(), digest);
  EXPECT_FALSE(run.go_to_tick(100'000));
  EXPECT_TRUE(run.state().seen.over);
}

TEST(ReversibleRun, ComesBackFromTheEnd) {
  const Scenario scenario = lively_on(Engine::kModel);
  ReversibleRun run{scenario};
  EXPECT_FALSE(run.state().seen.over);
  EXPECT_TRUE(run.go_to(kEndOfTime).seen.over);
  EXPECT_EQ(run.state().now(), to_cycles(scenario.duration_s));
  const std::string end{run.state().digest_text()};
  EXPECT_FALSE(run.go_to(Cycles{10'000}).seen.over);
  EXPECT_EQ(run.go_to(kEndOfTime).digest_text(), end);
}

// Without the figures of the host: a look at a run costs it whole ticks.
std::string without_host(const std::string& summary) {
  auto values = nlohmann::ordered_json::parse(summary);
  EXPECT_EQ(values.erase("host"), 1u);
  return values.dump();
}

void expect_results_of_plain_run(Scenario scenario) {
  scenario.trace.every_ticks = 1;
  test::RecordedRun plain{scenario};
  plain.run().advance(kEndOfTime);
  const test::RunTexts wanted = plain.finish();
  ReversibleRun run{scenario, {}, KeepTrace::kYes};
  for (const Cycles cycle : random_cycles(scenario, 20)) run.go_to(cycle);
  for (int time = 0; time < 2; ++time) {
    const ReversibleRun::Results results = run.finish();
    EXPECT_TRUE(run.state().seen.over);
    EXPECT_EQ(without_host(results.summary), without_host(wanted.summary));
    EXPECT_TRUE(results.trace == wanted.trace) << "other bytes";
    EXPECT_GT(results.trace.size(), 200'000u) << "a text of several parts";
    run.go_to(Cycles{1'234'567});
    EXPECT_FALSE(run.state().seen.over);
  }
}

TEST(ReversibleRun, HasTheResultsOfAPlainRunOnTheModel) {
  expect_results_of_plain_run(lively_on(Engine::kModel));
}

TEST(ReversibleRun, HasTheResultsOfAPlainRunOnTheRtl) {
  expect_results_of_plain_run(lively_on(Engine::kRtl));
}

TEST(ReversibleRun, IsFinishedOnceMoreAtItsEnd) {
  ReversibleRun run{lively_on(Engine::kModel), {}, KeepTrace::kYes};
  const ReversibleRun::Results first = run.finish(), second = run.finish();
  EXPECT_FALSE(first.trace.empty());
  EXPECT_TRUE(first.summary == second.summary && first.trace == second.trace);
}

TEST(ReversibleRun, KeepsNoTraceUnlessItIsAskedTo) {
  ReversibleRun run{lively_on(Engine::kModel)};
  const ReversibleRun::Results results = run.finish();
  EXPECT_FALSE(results.summary.empty());
  EXPECT_TRUE(results.trace.empty());
}

class OnFault final : public StopCondition {
 public:
  void on_event(const Event& event, const RunPlace& place) override {
    if (std::holds_alternative<Faulted>(event)) meet(place.at);
  }
};

class OnOutput final : public StopCondition {
 public:
  void on_signal(const Signal& signal, const RunPlace& place) override {
    if (std::holds_alternative<OutputLevel>(signal)) meet(place.at);
  }
};

TEST(ReversibleRun, StopsBehindTheCycleThatMeetsACondition) {
  OnFault on_fault;
  OnOutput on_output;
  ReversibleRun run{lively_on(Engine::kModel), {&on_fault, &on_output}};
  EXPECT_FALSE(run.advance_to(0, Cycles{1'000'000}));
  EXPECT_EQ(run.state().now(), Cycles{1'000'000});
  ASSERT_TRUE(run.advance_to(0, kEndOfTime));
  const RunState fault = run.state();
  EXPECT_EQ(fault.seen.telemetry.state, MotionState::kFault);
  const RunState before = run.go_to(fault.now() - Cycles{1});
  EXPECT_LT(before.heard, fault.heard);
  ASSERT_TRUE(run.advance_to(0, kEndOfTime)) << "once more";
  EXPECT_EQ(run.state().digest_text(), fault.digest_text());
  EXPECT_FALSE(run.advance_to(0, kEndOfTime));
  EXPECT_TRUE(run.state().seen.over);
  run.go_to(Cycles{0});
  EXPECT_TRUE(run.advance_to(1, kEndOfTime));
  EXPECT_EQ(run.state().seen.outputs.gpio, 2);
}

TEST(ReversibleRun, SaysWhatTheHostLacks) {
  const auto run = [] {
    test::refuse_copies();
    try {
      const ReversibleRun refused{lively_on(Engine::kModel)};
    } catch (const std::runtime_error& error) {
      std::fputs(error.what(), stderr);
      ::_exit(0);
    }
    ::_exit(1);
  };
  EXPECT_EXIT(run(), testing::ExitedWithCode(0), "ulimit -u");
}

class Throws final : public StopCondition {
 public:
  void on_row(const TraceRow& row, const IntegerDigest&) override {
    if (row.tick == 50) throw std::runtime_error{"cannot continue"};
  }
};

TEST(ReversibleRun, SaysWhyItCannotContinue) {
  Throws throws;
  ReversibleRun run{lively_on(Engine::kModel), {&throws}};
  try {
    run.go_to_tick(60);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "cannot continue");
  }
  EXPECT_THROW(run.go_to(Cycles{0}), std::runtime_error);
}

TEST(ReversibleRun, LeavesNoProcess) {
  {
    ReversibleRun run{lively_on(Engine::kModel)};
    run.go_to(Cycles{2'000'000});
    run.go_to(Cycles{1'000'000});
  }
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

}  // namespace
}  // namespace armature::cosim
