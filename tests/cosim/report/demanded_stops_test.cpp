// A stop that was demanded and not executed in time is found, whoever demanded it; one in time is not.
#include "cosim/report/measure/demanded_stops.hpp"

#include <gtest/gtest.h>

#include "cosim/report/judge/expect.hpp"
#include "cosim/report/measure/run_facts.hpp"

namespace armature::cosim {
namespace {

constexpr std::int64_t kLimit = DemandedStops::kLongest.value();

RunPlace place(std::int64_t cycle) {
  return {.tick = cycle / 2'500, .at = Cycles{cycle}};
}

DemandedStops with_servos_on() {
  DemandedStops stops;
  stops.servo_enables(0x3F, Cycles{10});
  return stops;
}

TEST(DemandedStops, AStopIsMissedWhenAServoStaysOnLongerThanTheLimit) {
  DemandedStops stops = with_servos_on();
  EXPECT_FALSE(stops.missed(Cycles{1'000'000}));
  stops.demand("estop", place(1'000));
  stops.servo_enables(0x20, Cycles{1'500});
  EXPECT_FALSE(stops.missed(Cycles{1'000 + kLimit}));
  const auto missed = stops.missed(Cycles{1'001 + kLimit});
  ASSERT_TRUE(missed);
  EXPECT_EQ(missed->by, "estop");
  EXPECT_FALSE(missed->executed);
  stops.servo_enables(0, Cycles{1'000 + kLimit});
  EXPECT_FALSE(stops.missed(Cycles{100'000'000}));
}

TEST(DemandedStops, AStopThatIsLateStaysMissed) {
  DemandedStops stops = with_servos_on();
  stops.demand("estop", place(1'000));
  stops.servo_enables(0, Cycles{1'001 + kLimit});
  ASSERT_TRUE(stops.missed(Cycles{100'000'000}));
  EXPECT_EQ(stops.missed(Cycles{100'000'000})->executed, Cycles{1'001 + kLimit});
  stops.servo_enables(0x3F, Cycles{200'000});
  EXPECT_TRUE(stops.missed(Cycles{100'000'000}));
}

TEST(DemandedStops, WithTheServosOffNothingIsMissed) {
  DemandedStops stops;
  stops.demand("estop", place(1'000));
  stops.row(place(2'000));
  EXPECT_FALSE(stops.missed(Cycles{100'000'000}));
  stops.servo_enables(0x3F, Cycles{3'000'000});
  stops.row(place(3'000'100));
  EXPECT_FALSE(stops.missed(Cycles{3'000'200}));
}

TEST(DemandedStops, TicksThatDoNotComeDemandAStop) {
  DemandedStops stops = with_servos_on();
  stops.row(place(2'500));
  stops.row(place(2'500 + kLimit));
  EXPECT_FALSE(stops.missed(Cycles{2'500 + 2 * kLimit}));
  EXPECT_TRUE(stops.missed(Cycles{2'501 + 2 * kLimit})) << "at the end of the run";
  DemandedStops late = stops;
  late.row(place(2'501 + 2 * kLimit));
  EXPECT_TRUE(late.missed(Cycles{2'502 + 2 * kLimit})) << "a trigger came again";
  stops.servo_enables(0, Cycles{2'500 + 2 * kLimit});
  EXPECT_FALSE(stops.missed(Cycles{100'000'000}));
}

TEST(DemandedStops, ASlowerDropOutHasItsTime) {
  DemandedStops stops = with_servos_on();
  stops.set_drop_out(Cycles{3 * kLimit});
  stops.row(place(0));
  EXPECT_FALSE(stops.missed(Cycles{3 * kLimit + 2'500}));
  EXPECT_TRUE(stops.missed(Cycles{3 * kLimit + 2'501}));
}

TEST(DemandedStops, NoExpectationLetsSuchARunPass) {
  RunFacts facts;
  facts.cycles = Cycles{1'000 + 2 * kLimit};
  facts.ticks = facts.cycles.value() / 2'500;
  facts.stops = with_servos_on();
  facts.stops.demand("core 0 stopped", place(1'000));
  facts.bus_aborts.push_back({.core = 0, .error = BusError::kSlaveError});
  ExpectSpec expect;
  expect.bus_error = "SLVERR";
  const auto failures = check(expect, facts);
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_EQ(failures[0].key, "missed_stop");
  EXPECT_EQ(failures[0].got, "the stop by core 0 stopped: the servos stay on");
  facts.stops.servo_enables(0, Cycles{2'000});
  EXPECT_TRUE(check(expect, facts).empty());
}

}  // namespace
}  // namespace armature::cosim
