#include "cosim/kernel/simulation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <utility>
#include <vector>

#include "cosim/fabric/fabric_wrapper.hpp"
#include "cosim/fabric/verilated_fabric.hpp"
#include "cosim/kernel/scenario_soc.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "cosim/time/clock.hpp"
#include "tests/support/pin_soc.hpp"
#include "tests/support/silent_listener.hpp"

namespace armature::cosim {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

class Rows final : public test::SilentListener {
 public:
  void on_row(TraceRow& row) override { rows.push_back(row); }
  void on_signal(const Signal& signal, Cycles now) override {
    const auto* abort = std::get_if<BusAbort>(&signal);
    if (abort == nullptr) return;
    aborts.push_back(*abort);
    aborted_at = now;
  }
  void on_event(const Event& event, Cycles) override {
    if (const auto* move = std::get_if<MoveStarted>(&event)) moves.push_back(*move);
    if (const auto* move = std::get_if<MoveFinished>(&event)) finished.push_back(*move);
    if (const auto* fault = std::get_if<Faulted>(&event)) faults.push_back(fault->cause);
    if (std::holds_alternative<MoveRefused>(event)) ++refused;
  }

  std::vector<TraceRow> rows;
  std::vector<MoveStarted> moves;
  std::vector<MoveFinished> finished;
  std::vector<FaultCause> faults;
  std::vector<BusAbort> aborts;
  Cycles aborted_at{};
  int refused = 0;
};

// 20 ms with one small move of every axis at 2 ms.
Scenario short_move() {
  const std::filesystem::path scenarios = ARMATURE_SOURCE_DIR "/scenarios";
  Scenario scenario = load_scenario(scenarios / "fig9_joint_move", {.search_path = scenarios, .overrides = {}});
  scenario.duration_s = 0.02;
  scenario.moves.front().at_s = 0.002;
  scenario.moves.front().kind = JointSpec{.target_deg = PerAxis<double>{0.02, -0.02, 0.01, 0.01, -0.01, 0.02}};
  return scenario;
}

SimulationEnd run(const Scenario& scenario, Rows& rows, std::unique_ptr<Fabric> fabric = make_verilated_fabric()) {
  return test::run_to_end(Simulation{scenario, test::pin_soc(std::move(fabric), scenario.bus, scenario.seed), rows});
}

// The real logic, with one thing about it gone wrong from a given cycle on.
class BrokenFabric final : public FabricWrapper {
 public:
  enum class Fault { kSlaveError, kDecodeError, kSilentBus, kCheck };
  BrokenFabric(Fault fault, Cycles from) : FabricWrapper{make_verilated_fabric()}, fault_{fault}, from_{from} {}

  bool run(std::int64_t limit) override {
    if (fault_ == Fault::kCheck && cycle() >= from_) throw LogicCheckFailed{cycle()};
    return inner().run(limit);
  }
  [[nodiscard]] AxiSlavePins slave() const override {
    AxiSlavePins pins = inner().slave();
    if (cycle() < from_) return pins;
    if (fault_ == Fault::kSlaveError) pins.bresp = pins.rresp = 0b10;
    if (fault_ == Fault::kDecodeError) pins.bresp = pins.rresp = 0b11;
    if (fault_ == Fault::kSilentBus) pins.bvalid = pins.rvalid = false;
    return pins;
  }

 private:
  Fault fault_;
  Cycles from_;
};

TEST(Simulation, GivesOneRowPerTriggerAndTriggersExactlyOneTickApart) {
  Rows rows;
  const SimulationEnd end = run(short_move(), rows);
  EXPECT_EQ(end.reason, EndReason::kFinished) << end.failure;
  EXPECT_EQ(end.cycles, Cycles{1'000'000});
  ASSERT_GE(rows.rows.size(), 398u);
  for (std::size_t i = 1; i < rows.rows.size(); ++i) {
    ASSERT_EQ(rows.rows[i].tick, static_cast<std::int64_t>(i));
    ASSERT_EQ(rows.rows[i].cycle - rows.rows[i - 1].cycle, kTickCycles);
  }
}

TEST(Simulation, EmitsACountOneTickAfterItWasComputed) {
  Rows rows;
  run(short_move(), rows);
  const auto differs = [&](auto value) {
    for (const TraceRow& row : rows.rows) {
      if (value(row) != 0) return row.tick;
    }
    return std::int64_t{-1};
  };
  const auto commanded = differs([](const TraceRow& row) { return row.telemetry.commanded[0].value(); });
  const auto emitted = differs([](const TraceRow& row) { return row.pin_pulses[0]; });
  EXPECT_GT(commanded, 0);
  EXPECT_EQ(emitted, commanded + 1);
}

// The uncertainty of the synchronisers may shift what the encoders show at a trigger by a count. What is commanded
// without feedback does not depend on it, nor does the position at the end, and no pulse or count is lost.
TEST(Simulation, InputJitterChangesNoPulseWithoutFeedbackAndNoFinalPosition) {
  for (const bool feedback : {false, true}) {
    Scenario scenario = short_move();
    scenario.controller.feedback = feedback;
    scenario.engine = Engine::kModel;
    Rows exact;
    EXPECT_EQ((test::run_to_end(Simulation{scenario, make_soc(scenario), exact}).reason), EndReason::kFinished);
    scenario.input_jitter = true;
    for (scenario.seed = 1; scenario.seed <= 5; ++scenario.seed) {
      Rows jittery;
      const SimulationEnd end = test::run_to_end(Simulation{scenario, make_soc(scenario), jittery});
      ASSERT_EQ(end.reason, EndReason::kFinished) << end.failure;
      ASSERT_EQ(jittery.rows.size(), exact.rows.size());
      EXPECT_TRUE(jittery.faults.empty());
      for (std::size_t i = 0; i < exact.rows.size() && !feedback; ++i) {
        ASSERT_EQ(jittery.rows[i].pin_pulses, exact.rows[i].pin_pulses) << "row " << i << ", seed " << scenario.seed;
        ASSERT_EQ(jittery.rows[i].cycle, exact.rows[i].cycle);
      }
      EXPECT_EQ(jittery.rows.back().motor_counts, exact.rows.back().motor_counts);
      EXPECT_EQ(jittery.rows.back().telemetry.encoder, exact.rows.back().telemetry.encoder);
    }
  }
}

TEST(Simulation, InputJitterDelaysAnEmergencyStopByAClockAtMost) {
  class Stops final : public test::SilentListener {
   public:
    void on_row(TraceRow& row) override { last = row; }
    void on_event(const Event& event, Cycles) override { faults += std::holds_alternative<Faulted>(event); }
    void on_signal(const Signal& signal, Cycles now) override {
      const auto* enables = std::get_if<ServoEnables>(&signal);
      if (enables != nullptr && enables->levels == 0) off = now;
    }
    TraceRow last;
    int faults = 0;
    Cycles off{};
  };
  Scenario scenario = short_move();
  scenario.faults = {{.at_s = 0.008, .kind = Estop{.duration_s = 0.002}}};
  scenario.engine = Engine::kModel;
  Stops exact;
  EXPECT_EQ((test::run_to_end(Simulation{scenario, make_soc(scenario), exact}).reason), EndReason::kFinished);
  EXPECT_EQ(exact.faults, 1);
  scenario.input_jitter = true;
  int late = 0;
  for (scenario.seed = 1; scenario.seed <= 8; ++scenario.seed) {
    SCOPED_TRACE(testing::Message() << "seed " << scenario.seed);
    Stops jittery;
    const SimulationEnd end = test::run_to_end(Simulation{scenario, make_soc(scenario), jittery});
    ASSERT_EQ(end.reason, EndReason::kFinished) << end.failure;
    EXPECT_EQ(jittery.faults, 1);
    const std::int64_t delay = (jittery.off - exact.off).value();
    EXPECT_TRUE(delay == 0 || delay == 1) << delay;
    late += delay == 1;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      EXPECT_LE(std::abs(jittery.last.pin_pulses[axis] - exact.last.pin_pulses[axis]), 1);
      EXPECT_LE(std::abs(jittery.last.telemetry.encoder[axis].value() - jittery.last.motor_counts[axis]), 1);
    }
  }
  EXPECT_TRUE(late > 0 && late < 8) << late << " of 8 stops were late";
}

TEST(Simulation, AnInterruptEndsItAtOnce) {
  Rows rows;
  const Scenario scenario = short_move();
  Simulation simulation{scenario, make_soc(scenario), rows};
  const Cycles between_two_triggers{26'000};
  EXPECT_TRUE(simulation.advance(between_two_triggers));
  EXPECT_EQ(simulation.now(), between_two_triggers);
  const std::size_t seen = rows.rows.size();
  EXPECT_GT(seen, 0u);
  simulation.interrupt();
  EXPECT_FALSE(simulation.advance(Cycles{1'000'000}));
  const SimulationEnd end = simulation.finish();
  EXPECT_EQ(end.reason, EndReason::kInterrupted) << end.failure;
  EXPECT_EQ(end.cycles, between_two_triggers);
  EXPECT_EQ(rows.rows.size(), seen);
}

TEST(Simulation, ThatIsNotOverEndsAsInterrupted) {
  Rows rows;
  const Scenario scenario = short_move();
  Simulation simulation{scenario, make_soc(scenario), rows};
  EXPECT_TRUE(simulation.advance(Cycles{10'000}));
  const SimulationEnd end = simulation.finish();
  EXPECT_EQ(end.reason, EndReason::kInterrupted) << end.failure;
  EXPECT_EQ(end.cycles, Cycles{10'000});
}

TEST(Simulation, AnInterruptAfterItsEndChangesNothing) {
  Rows rows;
  const Scenario scenario = short_move();
  Simulation simulation{scenario, make_soc(scenario), rows};
  EXPECT_FALSE(simulation.advance(Cycles{2'000'000}));
  EXPECT_FALSE(simulation.advance(Cycles{3'000'000}));
  simulation.interrupt();
  const SimulationEnd end = simulation.finish();
  EXPECT_EQ(end.reason, EndReason::kFinished) << end.failure;
  EXPECT_EQ(end.cycles, Cycles{1'000'000});
}

// The end meets the cores in the middle of accesses, computations and waits. What a core still computed would take
// minutes: 2^32 ticks of a counter that reads 0, or the rest of a plan of 600 s.
TEST(Simulation, ExecutesNothingOfTheControllerAfterItsEnd) {
  const auto processor_s = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
  const double begin_s = processor_s();
  Scenario scenario = short_move();
  scenario.bus.latency_cycles = 100;
  scenario.bus.stall_probability = 0.5;
  for (int i = 0; i < 30; ++i) {
    scenario.duration_s = 0.00602 + 4e-5 * i;
    Rows rows;
    EXPECT_EQ(run(scenario, rows).reason, EndReason::kFinished);
  }
  Scenario crawling = short_move();
  CommandSpec& line = crawling.moves.front();
  line.at_s = 0;
  line.kind = LineSpec{.path = {.pose = {.xyz_mm = {0, 0, -5.9}, .frame = kToolFrameIndex}, .speed_mm_s = 0.01}};
  Rows rows;
  EXPECT_EQ(run(crawling, rows).reason, EndReason::kFinished);
  EXPECT_EQ(rows.refused, 0);
  EXPECT_LT(processor_s() - begin_s, 40);
}

TEST(Simulation, StallsOfTheBusDoNotChangeTheMotion) {
  Scenario scenario = short_move();
  Rows calm, stalled;
  run(scenario, calm);
  scenario.bus.stall_probability = 0.4;
  const SimulationEnd end = run(scenario, stalled);
  ASSERT_EQ(end.reason, EndReason::kFinished) << end.failure;
  ASSERT_EQ(calm.rows.size(), stalled.rows.size());
  for (std::size_t i = 0; i < calm.rows.size(); ++i) {
    ASSERT_EQ(calm.rows[i].pin_pulses, stalled.rows[i].pin_pulses) << "tick " << i;
  }
}

TEST(Simulation, AnAccessThatTakesTooLongEndsTheRunWithAddressCoreAndCycle) {
  Scenario scenario = short_move();
  scenario.bus.timeout_cycles = 3;
  Rows rows;
  const SimulationEnd end = run(scenario, rows);
  EXPECT_EQ(end.reason, EndReason::kFailed);
  EXPECT_THAT(end.failure, MatchesRegex("bus: (read|write) at 0x4[0-9A-F]+ by core 0: .*time-out .cycle [0-9]+."));
}

TEST(Simulation, ErrorResponsesEndTheRunWithAddressCoreAndCycle) {
  using Fault = BrokenFabric::Fault;
  for (const auto& [fault, message] :
       {std::pair{Fault::kSlaveError, "SLVERR"}, {Fault::kDecodeError, "DECERR"}, {Fault::kSilentBus, "time-out"}}) {
    Rows rows;
    const SimulationEnd end = run(short_move(), rows, std::make_unique<BrokenFabric>(fault, Cycles{300'000}));
    EXPECT_EQ(end.reason, EndReason::kFailed);
    EXPECT_THAT(end.failure, MatchesRegex("bus: (read|write) at 0x4[0-9A-F]+ by core 0: .*cycle 30[0-9]+."));
    EXPECT_THAT(end.failure, HasSubstr(message));
    EXPECT_THAT(rows.faults, testing::IsEmpty()) << "what a switched-off core does is no event of the run";
  }
}

// The crossbar answers in place of the encoder. Core 0 stops, and the watchdog of the logic stops the arm.
TEST(Simulation, ABlockThatHangsStopsTheCoreThatReadsItAndThenTheArm) {
  Scenario scenario = short_move();
  scenario.faults = {{.at_s = 0.0043, .kind = BlockHang{.clock = ClockGroup::kEncoder}}};
  Rows rows;
  const SimulationEnd end = run(scenario, rows);
  EXPECT_EQ(end.reason, EndReason::kFinished) << end.failure;
  EXPECT_EQ(end.cycles, Cycles{1'000'000}) << "time continues after the abort";
  ASSERT_EQ(rows.aborts.size(), 1u);
  EXPECT_EQ(rows.aborts[0].access.core, 0);
  EXPECT_EQ(rows.aborts[0].access.request.addr & 0xFFFF'0000u, 0x43C2'0000u);
  EXPECT_EQ(rows.aborts[0].error, BusError::kSlaveError);
  EXPECT_GE(rows.aborted_at, Cycles{215'000 + 128});
  EXPECT_LT(rows.aborted_at, Cycles{215'000 + kTickCycles + 1'000});
  const auto stopped = std::ranges::find_if(rows.rows, &TraceRow::stopped);
  ASSERT_NE(stopped, rows.rows.end()) << "the watchdog disables the drives";
  EXPECT_LE(Cycles{stopped->cycle} - rows.aborted_at, Cycles{6 * kTickCycles});
  EXPECT_EQ(stopped->pin_pulses, rows.rows.back().pin_pulses);
  EXPECT_THAT(rows.faults, testing::IsEmpty()) << "the core that would report it has stopped";
}

// Nothing reads the tool or the serial line in this scenario.
TEST(Simulation, ABlockThatHangsDisturbsNobodyWhoDoesNotUseIt) {
  Scenario scenario = short_move();
  Rows healthy, hung;
  run(scenario, healthy);
  scenario.faults = {{.at_s = 0.0043, .kind = BlockHang{.clock = ClockGroup::kIo}}};
  const SimulationEnd end = run(scenario, hung);
  EXPECT_EQ(end.reason, EndReason::kFinished) << end.failure;
  EXPECT_THAT(hung.aborts, testing::IsEmpty());
  EXPECT_EQ(hung.rows.back().pin_pulses, healthy.rows.back().pin_pulses);
}

TEST(Simulation, AFailedCheckInsideTheLogicEndsTheRun) {
  Rows rows;
  const auto fault = BrokenFabric::Fault::kCheck;
  const SimulationEnd end = run(short_move(), rows, std::make_unique<BrokenFabric>(fault, Cycles{300'000}));
  EXPECT_EQ(end.reason, EndReason::kFailed);
  EXPECT_THAT(end.failure, HasSubstr("a check inside the logic failed at cycle 30"));
}

TEST(Simulation, EndingAtAnyCycleOfATickLeavesNoEventBehind) {
  for (std::int64_t cycle = 0; cycle < kTickCycles; cycle += 61) {
    Scenario scenario = short_move();
    scenario.duration_s = to_seconds(Cycles{900'000 + cycle});
    scenario.engine = Engine::kModel;
    // Away from zero and strict: a position read as 0 would be a following error.
    for (AxisSpec& axis : scenario.robot.axes) {
      axis.drive.natural_hz = 400;
      axis.following_error_deg = 0.008;
    }
    Rows rows;
    const SimulationEnd end = test::run_to_end(Simulation{scenario, make_soc(scenario), rows});
    ASSERT_EQ(end.reason, EndReason::kFinished) << end.failure;
    ASSERT_THAT(rows.faults, testing::IsEmpty()) << "at cycle " << cycle;
  }
}

TEST(Simulation, OverlappingEmergencyStopsHoldUntilTheLastIsReleased) {
  Scenario scenario = short_move();
  scenario.faults = {{.at_s = 0.004, .kind = Estop{.duration_s = 0.001}},
                     {.at_s = 0.004, .kind = Estop{.duration_s = 0.009}}};
  CommandSpec clear;
  clear.kind = ClearFaultSpec{};
  clear.at_s = 0.012;  // after the first release, before the second
  scenario.moves.push_back(clear);
  Rows rows;
  run(scenario, rows);
  EXPECT_EQ(rows.rows.back().telemetry.state, MotionState::kFault);
}

TEST(Simulation, APulseThatIsTooShortForTheDriveEndsTheRun) {
  Scenario scenario = short_move();
  for (AxisSpec& axis : scenario.robot.axes) axis.drive.min_step_high_ns = 1e6;
  Rows rows;
  const SimulationEnd end = run(scenario, rows);
  EXPECT_EQ(end.reason, EndReason::kFailed);
  EXPECT_THAT(end.failure, HasSubstr("axis"));
  EXPECT_THAT(end.failure, HasSubstr("the drive needs 50000 cycles"));
}

TEST(Simulation, TheSameScenarioGivesTheSameRowsTwice) {
  Rows first, second;
  run(short_move(), first);
  run(short_move(), second);
  ASSERT_EQ(first.rows.size(), second.rows.size());
  for (std::size_t i = 0; i < first.rows.size(); ++i) {
    ASSERT_EQ(first.rows[i].cycle, second.rows[i].cycle);
    ASSERT_EQ(first.rows[i].motor_to, second.rows[i].motor_to);
    ASSERT_EQ(first.rows[i].telemetry.encoder, second.rows[i].telemetry.encoder);
  }
}

TEST(Simulation, AnEmergencyStopAtTheStartKeepsTheArmStill) {
  Scenario scenario = short_move();
  scenario.faults = {{.at_s = 0, .kind = Estop{.duration_s = 1.0}}};
  Rows rows;
  const SimulationEnd end = run(scenario, rows);
  EXPECT_EQ(end.reason, EndReason::kFinished) << end.failure;
  EXPECT_EQ(rows.faults, (std::vector{FaultCause::kEstop}));
  EXPECT_EQ(rows.refused, 1);
  EXPECT_EQ(rows.rows.back().pin_pulses, (PerAxis<std::int64_t>{}));
}

}  // namespace
}  // namespace armature::cosim
