// Two equal faults that overlap in time are as one that lasts from the first begin to the last end. The faults are
// drawn as those of a campaign.
#include <gtest/gtest.h>

#include <concepts>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "cosim/campaign/draw.hpp"
#include "cosim/campaign/draw_fault.hpp"
#include "cosim/scenario/fault_text.hpp"
#include "cosim/scenario/kinds.hpp"
#include "cosim/scenario/tables/fault_kinds.hpp"
#include "tests/cosim/support/scenario_files.hpp"
#include "tests/cosim/support/whole_run.hpp"

namespace armature::cosim {
namespace {

constexpr std::uint64_t kSeed = 20261130;
constexpr double kMovesS = 0.03, kHeldByBrakesS = 0.12;
constexpr int kOfAKind = 5;  // draws

// Two of them do more than one, or their seconds fall on other cycles.
template <class Kind>
constexpr bool kAddsUp =
    std::same_as<Kind, EncoderSwapped> || std::same_as<Kind, EncoderChatter> || std::same_as<Kind, EncoderNoise> ||
    std::same_as<Kind, SwitchBounce> || std::same_as<Kind, UartNoise> || std::same_as<Kind, SlowSlave> ||
    std::same_as<Kind, CollisionTorque>;

template <class Kind>
constexpr bool kIsAsOne = FaultWithDuration<Kind> && !kAddsUp<Kind>;

FaultSpec lasting(FaultSpec fault, double begin_s, double end_s) {
  fault.at_s = begin_s;
  std::visit(
      [&]<class Kind>(Kind& kind) {
        if constexpr (FaultWithDuration<Kind>) kind.duration_s = end_s - begin_s;
      },
      fault.kind);
  return fault;
}

// An arm with gravity moves until 0.04 s, is held by its brakes, and is reset.
Scenario scenario_with_fault(const std::string& fault) {
  const std::string text = R"(description = "overlap"
robot = "vo2021_6r_dynamic"
duration_s = 0.2
engine = "model"
[[move]]
at_s = 0.01
type = "joint"
target_deg = [10, 10, 10, 10, 10, 10]
[[move]]
at_s = 0.17
type = "clear_fault"
[[fault]]
at_s = 0.04
kind = "estop"
duration_s = 0.12
[[fault]]
)" + fault;
  const test::TempFolder folder;
  return load_scenario(folder.write("s/scenario.toml", text), test::shipped());
}

class Rows final : public RunListener {
 public:
  void on_row(const TraceRow& row, const IntegerDigest&) override {
    rows.push_back({row.cycle, row.motor_counts, row.telemetry.encoder, row.pin_pulses});
  }
  std::vector<std::tuple<std::int64_t, PerAxis<std::int64_t>, PerAxis<Counts>, PerAxis<std::int64_t>>> rows;
};

std::pair<std::string, decltype(Rows::rows)> run_of(Scenario scenario, const std::vector<FaultSpec>& faults) {
  scenario.faults.insert(scenario.faults.end(), faults.begin(), faults.end());
  Rows rows;
  const RunSummary summary = test::summary_of(scenario, {&rows});
  EXPECT_EQ(summary.failure, std::nullopt);
  return {std::string{summary.outcome()}, std::move(rows.rows)};
}

void expect_as_one(const Scenario& scenario, const FaultSpec& fault, Draw& draw) {
  const auto after = [&](double at_s) { return at_s + 1e-3 * static_cast<double>(draw.integer(1, 5)); };
  const double begin_s = draw.chance(0.5) ? kMovesS : kHeldByBrakesS;
  const double middle_s = after(begin_s), end_s = after(middle_s), last_s = after(end_s);
  const auto one = run_of(scenario, {lasting(fault, begin_s, last_s)});
  EXPECT_TRUE(run_of(scenario, {lasting(fault, begin_s, end_s), lasting(fault, middle_s, last_s)}) == one);
  EXPECT_TRUE(run_of(scenario, {lasting(fault, begin_s, last_s), lasting(fault, middle_s, end_s)}) == one);
}

TEST(OverlappingFaults, OfTheSameKindAndPlaceAreAsOne) {
  const RobotSpec robot = scenario_with_fault("at_s = 0.05\nkind = \"core1_stuck\"\n").robot;
  std::map<std::string_view, int> left;
  for_each_kind<FaultKind>([&]<class Kind>(std::type_identity<Kind>) {
    if (kIsAsOne<Kind>) left[fault_entry<Kind>().name] = kOfAKind;
  });
  for (std::uint64_t number = 0; !left.empty(); ++number) {
    ASSERT_LT(number, 2'000u) << left.begin()->first << " is not drawn";
    Draw draw{kSeed, 0, number};
    const std::string text = draw_fault(draw, robot, kHeldByBrakesS);
    Scenario scenario = scenario_with_fault(text);
    const FaultSpec fault = scenario.faults.back();  // they are sorted by time
    scenario.faults.pop_back();
    const auto kind = left.find(fault_kind_name(fault.kind));
    if (kind == left.end()) continue;
    if (--kind->second == 0) left.erase(kind);
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", fault " << number << ": " << text);
    expect_as_one(scenario, fault, draw);
  }
}

}  // namespace
}  // namespace armature::cosim
