#include "controller/activity/plans/path_pins.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <variant>
#include <vector>

#include "tests/controller/support/finish_plan.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature {
namespace {

using test::kReady;
using test::PathRig;

// The ticks in which each pin was written.
class Writes final : public EventListener {
 public:
  void on_event(const Event& event) noexcept override {
    const auto& output = std::get<OutputSwitched>(event);
    ticks[output.pin].push_back(output.tick.value());
  }
  std::map<int, std::vector<std::int64_t>> ticks;
};

constexpr double kLine_mm = 4.0;

std::vector<SegmentRequest> lines(const Transform& from, int count) {
  std::vector<SegmentRequest> result;
  for (int i = 1; i <= count; ++i) {
    result.push_back(test::line_to(test::moved(from, 0.0, kLine_mm * i, 0.0), test::kGentle));
  }
  return result;
}

void add_output(SegmentRequest& request, std::uint8_t pin, double mm) {
  PathOutputs& outputs = request.outputs;
  outputs.list[outputs.count++] = {.pin = pin, .level = true, .from = PathOutput::From::kStart, .offset = mm};
}

// Executes `plan`, and from its tick `change` on `window`, if there is one.
Writes written(const CartesianPlan& plan, const CartesianPlan* window, std::int64_t change) {
  Writes writes;
  PathPins pins;
  pins.begin();
  const CartesianPlan* active = &plan;
  double origin = 0.0;
  bool ended = false;
  for (std::int64_t tick = 1; !ended || pins.next().mask != 0; ++tick) {
    pins.written(Ticks{tick}, writes);
    if (window != nullptr && tick == change) {
      active = window;
      pins.continue_with(*window);
      origin = static_cast<double>(window->origin.value());
    }
    const auto end = static_cast<double>(active->duration.value());
    ended = static_cast<double>(tick) - origin >= end;
    pins.advance(Plan{Piece{*active}}, std::min(static_cast<double>(tick) - origin, end), ended);
  }
  pins.written(Ticks{1'000'000}, writes);  // nothing is left
  return writes;
}

// An output in each of the ticks around the change from a plan to its window, for each tick in which core 0 may change.
TEST(PathPins, AChangeToAWindowSwitchesEachOutputOnceAndInItsTick) {
  const auto rig = std::make_unique<PathRig>(test::irb120());
  const Transform from = rig->tool_at(kReady);
  constexpr Ticks kEarliest{500};
  auto plan = std::make_unique<CartesianPlan>();
  auto window = std::make_unique<CartesianPlan>();
  const auto make = [&](std::vector<SegmentRequest>& first, std::vector<SegmentRequest>& added) {
    ASSERT_EQ(rig->plan(kReady, first), CartesianPlanner::Progress::kDone);
    *plan = rig->planner.plan();
    ASSERT_TRUE(rig->planner.extend(kEarliest, 0.0, added));
    ASSERT_EQ(test::finish_plan(rig->planner), CartesianPlanner::Progress::kDone);
    *window = rig->planner.plan();
  };
  const auto all = lines(from, 20);
  std::vector<SegmentRequest> first(all.begin(), all.begin() + 10), added(all.begin() + 10, all.end());
  make(first, added);
  const std::int64_t origin = window->origin.value();
  const auto same = static_cast<std::int64_t>(window->same_until_ticks);
  ASSERT_GT(same, 4);
  const CartesianPlan without = *plan;

  for (std::int64_t at = -3; at < same + 3; ++at) {
    SCOPED_TRACE(at);
    const double share = at % 2 == 0 ? 0.3 : 0.7;  // written in the next tick or in the one after
    const double s = without.table.position((static_cast<double>(origin + at) + share) * kTickSeconds);
    const std::size_t segment = segment_on_path(without, s);
    const CartesianSegment& there = without.segments[segment];
    std::vector<SegmentRequest> with_first = first, with_added = added;
    add_output(with_first[0], 1, 0.01);
    add_output(with_first[segment], 2, (s - there.from) / there.length * kLine_mm);
    add_output(with_first[9], 3, 2.0);
    add_output(with_added[0], 4, 0.0);
    make(with_first, with_added);
    if (HasFatalFailure()) return;
    ASSERT_EQ(window->origin.value(), origin);

    // The plan brakes at the place of pin 3, the window does not.
    const CartesianSegment& last = window->segments[9 - window->dropped];
    const double ticks = window->table.time_at(last.from + 0.5 * last.length) / kTickSeconds;
    const auto outputs = window->outputs.view();
    ASSERT_GE(outputs.size(), 2u);
    EXPECT_EQ(outputs[outputs.size() - 2].pin, 3);
    EXPECT_NEAR(outputs[outputs.size() - 2].ticks, ticks, 1e-9);

    const Writes unchanged = written(*plan, nullptr, 0);
    ASSERT_EQ(unchanged.ticks.at(2).size(), 1u);
    const auto least = static_cast<std::int64_t>(CartesianPlan::kLeastTicks);
    for (std::int64_t change = origin + least + 1; change <= origin + same + 1; ++change) {
      SCOPED_TRACE(change - origin);
      const Writes writes = written(*plan, window.get(), change);
      EXPECT_EQ(writes.ticks.at(1), unchanged.ticks.at(1));
      EXPECT_EQ(writes.ticks.at(2), unchanged.ticks.at(2));
      ASSERT_EQ(writes.ticks.size(), 4u);
      EXPECT_EQ(writes.ticks.at(3).size(), 1u);
      EXPECT_EQ(writes.ticks.at(4).size(), 1u);
    }
  }
}

}  // namespace
}  // namespace armature
