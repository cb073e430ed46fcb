// Ticks that run as a whole give what their edges give, wherever they are disturbed.
//
// The oracle is the same simulation on the same model whose every edge is computed; the lock-step tests compare that
// one with the RTL.
#include "cosim/kernel/whole_ticks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "controller/regs/encoder_regs.hpp"
#include "controller/regs/pulse_train_regs.hpp"
#include "controller/regs/soc_map.hpp"
#include "cosim/kernel/scenario_soc.hpp"
#include "cosim/kernel/simulation.hpp"
#include "cosim/scenario/files/robot_loader.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "cosim/time/clock.hpp"
#include "tests/controller/support/draws.hpp"
#include "tests/cosim/kernel/other_soc.hpp"
#include "tests/support/silent_listener.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::cosim {
namespace {

using armature::test::SplitMix;
using test::AccessTimes;
using test::OtherSoc;

constexpr std::uint64_t kWholeTicksSeed = 2026;

// All that a run shows.
class Seen final : public test::SilentListener {
 public:
  void on_row(TraceRow& row) override { rows.push_back(row); }
  void on_event(const Event& event, Cycles now) override { events.emplace_back(now.value(), event.index()); }
  void on_signal(const Signal& signal, Cycles now) override { events.emplace_back(now.value(), 100 + signal.index()); }

  std::vector<TraceRow> rows;
  std::vector<std::pair<std::int64_t, std::size_t>> events;
  std::vector<AccessTimes> accesses;  // not compared: they depend on what runs ahead
  SimulationEnd end;
};

Seen run(const Scenario& scenario, std::uint32_t rarity, std::uint64_t seed = 0) {
  Seen seen;
  auto soc = std::make_unique<OtherSoc>(make_soc(scenario), rarity, seed, seen.accesses);
  seen.end = test::run_to_end(Simulation{scenario, std::move(soc), seen});
  return seen;
}

void expect_equal(const Seen& got, const Seen& wanted) {
  EXPECT_EQ(got.end.reason, wanted.end.reason) << got.end.failure;
  EXPECT_EQ(got.end.failure, wanted.end.failure);
  EXPECT_EQ(got.end.bus_reads, wanted.end.bus_reads);
  EXPECT_EQ(got.events, wanted.events);
  ASSERT_EQ(got.rows.size(), wanted.rows.size());
  for (std::size_t i = 0; i < got.rows.size(); ++i) {
    const TraceRow &a = got.rows[i], &b = wanted.rows[i];
    ASSERT_EQ(a.cycle, b.cycle) << "row " << i;
    ASSERT_EQ(a.pin_pulses, b.pin_pulses) << "row " << i;
    ASSERT_EQ(a.motor_counts, b.motor_counts) << "row " << i;
    ASSERT_EQ(a.first_rise, b.first_rise) << "row " << i;
    ASSERT_EQ(a.turned, b.turned) << "row " << i;
    ASSERT_EQ(a.motor_from, b.motor_from) << "row " << i;
    ASSERT_EQ(a.motor_to, b.motor_to) << "row " << i;
    ASSERT_EQ(a.telemetry.encoder, b.telemetry.encoder) << "row " << i;
    ASSERT_EQ(a.load[0].awake_cycles, b.load[0].awake_cycles) << "row " << i;
  }
}

const std::filesystem::path kShipped = ARMATURE_SOURCE_DIR "/scenarios";

// Joint moves of some ms, there and back, some with the highest rate of pulses; gears that are no whole numbers,
// switches on the way, any phase between ticks and steps of the motors.
Scenario random_moves(SplitMix& random) {
  const bool fast = random.below(3) == 0;
  Scenario scenario = load_scenario(kShipped / (fast ? "max_rate_4mpps" : "fig9_joint_move"),
                                    {.search_path = kShipped, .overrides = {}});
  scenario.engine = Engine::kModel;
  scenario.duration_s = 0.15;
  scenario.seed = random.next();
  scenario.bus.latency_cycles = 1 + random.below(12);
  const CommandSpec like = scenario.moves.front();
  scenario.moves.clear();
  for (int i = 0; i < 4; ++i) {
    CommandSpec move = like;
    move.at_s = 0.002 + 0.03 * i;
    PerAxis<double> target;
    const double size_deg = fast ? 80.0 : 0.1 * (1 + random.below(40));
    for (double& deg : target) deg = random.below(4) == 0 ? 0.0 : (random.below(2001) * 1e-3 - 1.0) * size_deg;
    move.kind = JointSpec{.target_deg = target};
    scenario.moves.push_back(move);
  }
  for (AxisSpec& axis : scenario.robot.axes) {
    if (random.below(2) == 0) axis.encoder_lines = 2048;
    if (random.below(4) == 0) axis.limit_switch_deg = {{-0.5, 0.9}};
  }
  if (random.below(2) == 0) {
    scenario.faults = {{.at_s = 0.05 + random.below(2500) * 20e-9, .kind = Estop{.duration_s = 0.01}}};
  }
  return scenario;
}

TEST(WholeTicks, GiveWhatTheirEdgesGive) {
  SplitMix random{kWholeTicksSeed};
  std::int64_t whole = 0, all = 0, most_pulses = 0;
  for (int i = 0; i < armature::test::draws(20); ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kWholeTicksSeed << ", scenario " << i);
    const Scenario scenario = random_moves(random);
    const Seen edges = run(scenario, 0);
    ASSERT_EQ(edges.end.whole_ticks, 0);
    const Seen ticks = run(scenario, 1'000'000'000);
    ASSERT_NO_FATAL_FAILURE(expect_equal(ticks, edges));
    whole += ticks.end.whole_ticks;
    all += static_cast<std::int64_t>(ticks.rows.size());
    for (std::size_t row = 1; row < ticks.rows.size(); ++row) {
      most_pulses = std::max(most_pulses, ticks.rows[row].pin_pulses[0] - ticks.rows[row - 1].pin_pulses[0]);
    }
  }
  EXPECT_GT(whole, 0);
  if (armature::test::few_draws()) return;
  EXPECT_GT(whole, all / 3) << "of " << all << " ticks; after an emergency stop none is whole";
  EXPECT_GT(most_pulses, 80) << "in a tick";
}

TEST(WholeTicks, GiveTheSameIfTheyAreDisturbedAnywhere) {
  SplitMix random{kWholeTicksSeed + 1};
  for (const std::uint32_t rarity : {15u, 60u, 400u}) {
    for (int i = 0; i < armature::test::draws(3); ++i) {
      SCOPED_TRACE(testing::Message() << "seed " << kWholeTicksSeed + 1 << ", one of " << rarity << ", scenario " << i);
      const Scenario scenario = random_moves(random);
      const Seen edges = run(scenario, 0);
      const Seen disturbed = run(scenario, rarity, random.next());
      ASSERT_NO_FATAL_FAILURE(expect_equal(disturbed, edges));
      EXPECT_GT(disturbed.end.whole_ticks, 0);
      EXPECT_LT(disturbed.end.whole_ticks, static_cast<std::int64_t>(edges.rows.size()));
    }
  }
}

// Cycles within six accesses of the tick that begins at `tick`, counted from there: where a fault stops a core that
// runs ahead.
std::vector<std::int64_t> cycles_of_accesses(std::vector<AccessTimes> accesses, Cycles tick, SplitMix& random) {
  std::erase_if(accesses, [&](const AccessTimes& access) {
    return access.begins < tick || access.ends >= tick + Cycles{kTickCycles};
  });
  EXPECT_GT(accesses.size(), 6u) << "accesses that run ahead";
  std::vector<std::int64_t> cycles;
  while (!accesses.empty() && cycles.size() < 6) {
    const AccessTimes access = accesses[random.below(static_cast<std::uint32_t>(accesses.size()))];
    const auto length = static_cast<std::uint32_t>((access.ends - access.begins).value());
    cycles.push_back((access.begins - tick).value() + 1 + random.below(length));
  }
  return cycles;
}

// Registers that core 0 reads or writes in each tick, and one that it does not read.
constexpr std::int64_t kPosition = regs::soc::kEncoderBase + regs::encoder::kPositionOffset;
constexpr std::int64_t kCommit = regs::soc::kPulseTrainBase + regs::pulse_train::kCommitOffset;
constexpr std::int64_t kNeverRead = regs::soc::kPulseTrainBase + regs::pulse_train::kIdOffset;

TEST(WholeTicks, AFaultAtAnyCycleOfATickGivesTheSame) {
  SplitMix random{kWholeTicksSeed + 2};
  Scenario scenario = random_moves(random);
  scenario.duration_s = 0.03;
  const Cycles tick{500'000};
  std::vector<std::int64_t> cycles = cycles_of_accesses(run(scenario, 1'000'000'000).accesses, tick, random);
  cycles.insert(cycles.end(), {0, 2497, 1, 1203, 2498, 2, 2397, 2499, 3, 500, 2496, 9});
  for (const std::int64_t cycle : armature::test::cases(cycles)) {
    const double at_s = static_cast<double>(tick.value() + cycle) * 20e-9;
    for (const FaultKind& kind : std::vector<FaultKind>{
             Estop{.duration_s = 0.002}, ClockStop{.duration_s = 0.001}, PulseLoss{.axis = 1, .count = 3},
             BlockHang{.clock = ClockGroup::kMotion}, BlockHang{.clock = ClockGroup::kEncoder},
             BlockHang{.clock = ClockGroup::kIo}, SlaveError{.address = kPosition, .count = 1},
             SlaveError{.address = kCommit, .count = 1}, SlaveError{.address = kNeverRead, .count = 1},
             UartNoise{.width_us = 1, .mean_gap_us = 30, .duration_s = 0.002}}) {
      SCOPED_TRACE(testing::Message() << "cycle " << cycle << ", fault " << kind.index());
      scenario.faults = {{.at_s = at_s, .kind = kind}};
      const Seen edges = run(scenario, 0);
      ASSERT_NO_FATAL_FAILURE(expect_equal(run(scenario, 1'000'000'000), edges));
    }
  }
}

TEST(WholeTicks, AFaultThatNoPulseAndNoEncoderSeesLetsTheTicksBeWhole) {
  SplitMix random{kWholeTicksSeed + 3};
  Scenario scenario = random_moves(random);
  scenario.duration_s = 0.03;
  scenario.faults.clear();
  const std::int64_t without = run(scenario, 1'000'000'000).end.whole_ticks;
  for (const FaultKind& kind :
       std::vector<FaultKind>{BlockHang{.clock = ClockGroup::kIo}, SlaveError{.address = kNeverRead, .count = 1}}) {
    scenario.faults = {{.at_s = 0.01, .kind = kind}};
    EXPECT_GE(run(scenario, 1'000'000'000).end.whole_ticks, without - 1) << "fault " << kind.index();
  }
}

// All kinds, at random times or at a condition. The model whose every edge is computed is the oracle.
FaultKind random_kind(SplitMix& random) {
  const int axis = static_cast<int>(1 + random.below(6));
  const auto line = static_cast<EncoderLine>(random.below(3));
  const auto which = static_cast<AxisSwitch>(random.below(3));
  const int level = static_cast<int>(random.below(2));
  const double us = 0.04 + random.below(2'000) * 0.01;
  const double duration_s = random.below(2) == 0 ? 20e-9 * random.below(200) + 20e-9 : 1e-5 * (1 + random.below(1'000));
  const std::int64_t counts = 1 + random.below(300);
  std::vector<FaultKind> kinds{
      PulseLoss{.axis = axis, .count = counts},
      SlowCore{.compute_us = us},
      Estop{.duration_s = duration_s},
      ClockStop{.duration_s = duration_s},
      BlockHang{.clock = static_cast<ClockGroup>(random.below(3))},
      ExtraPulses{.axis = axis, .count = counts},
      DriveAlarm{.axis = axis, .duration_s = duration_s},
      AxisBlocked{.axis = axis, .duration_s = duration_s},
      EncoderStuck{.axis = axis, .line = line, .level = level, .duration_s = duration_s},
      EncoderCable{.axis = axis, .duration_s = duration_s},
      EncoderSwapped{.axis = axis, .duration_s = duration_s},
      EncoderChatter{.axis = axis, .line = line, .period_us = us, .duration_s = duration_s},
      EncoderNoise{.axis = axis, .line = line, .width_us = us, .mean_gap_us = 10 * us, .duration_s = duration_s},
      EncoderMiscount{.axis = axis, .counts = counts},
      IndexSlip{.axis = axis, .counts = -counts},
      SwitchStuck{.axis = axis, .which = which, .level = level, .duration_s = duration_s},
      SwitchBounce{.axis = axis, .which = which, .period_us = us, .duration_s = duration_s},
      InterruptLost{.duration_s = duration_s},
      CoreOneStuck{},
      SlaveError{.address = kPosition, .count = counts},
      SlowSlave{.delay_us = us, .duration_s = duration_s},
      StrayWrite{.address = 0x4280'0000, .data = 0},
      RegisterFlip{.address = 0x43C1'0014, .bit = static_cast<int>(random.below(32))},
      BrakeSlip{.axis = axis, .share = 0.5, .duration_s = duration_s},
      CollisionTorque{.axis = axis, .torque_nm = 30, .duration_s = duration_s},
      UartBreak{.duration_s = duration_s},
      UartNoise{.width_us = us, .mean_gap_us = 10 * us, .duration_s = duration_s},
      UartOverrun{.duration_s = duration_s}};
  constexpr std::size_t kInside = 2;  // of FaultInside
  EXPECT_EQ(kinds.size(), std::variant_size_v<FaultKind> - kInside) << "a kind is not drawn";
  return kinds[random.below(static_cast<std::uint32_t>(kinds.size()))];
}

FaultSpec random_fault(SplitMix& random) {
  FaultSpec fault{.at_s = 0.002 + random.below(1'000'000) * 20e-9, .kind = random_kind(random)};
  fault.when = static_cast<FaultWhen>(random.below(2) == 0 ? 0 : random.below(4));
  fault.when_axis = static_cast<int>(1 + random.below(6));
  fault.when_deg = random.below(200) * 1e-3 - 0.1;
  fault.when_deg_s = 0.1 + random.below(100) * 0.1;
  return fault;
}

TEST(WholeTicks, FaultsOfAllKindsAndTheirConditionsGiveTheSame) {
  std::vector<std::uint64_t> seeds(60);
  std::iota(seeds.begin(), seeds.end(), kWholeTicksSeed);
  for (const std::uint64_t seed : armature::test::cases(seeds)) {
    SplitMix random{seed};
    Scenario scenario = random_moves(random);
    scenario.duration_s = 0.04;
    if (random.below(3) == 0) scenario.robot = load_robot(kShipped / "robots/vo2021_6r_dynamic.toml");
    for (std::uint32_t i = 1 + random.below(2); i > 0; --i) scenario.faults.push_back(random_fault(random));
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", fault " << scenario.faults[0].kind.index());
    const Seen edges = run(scenario, 0);
    EXPECT_EQ(edges.end.failure, "");
    ASSERT_NO_FATAL_FAILURE(expect_equal(run(scenario, 1'000'000'000), edges));
  }
}

}  // namespace
}  // namespace armature::cosim
