#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "cosim/plant/incremental_encoder.hpp"
#include "cosim/time/random.hpp"

namespace armature::cosim {
namespace {

constexpr std::int64_t kOne = kSubcountsPerCount;

Subcounts at(double counts) {
  return Subcounts{static_cast<std::int64_t>(counts * static_cast<double>(kOne))};
}

struct Levels {
  bool a, b, z;
  friend bool operator==(const Levels&, const Levels&) = default;
};

Levels levels(const IncrementalEncoder& encoder) {
  return {encoder.a(), encoder.b(), encoder.z()};
}

std::int64_t floor_div(std::int64_t a, std::int64_t b) {
  return a / b - (a % b != 0 && (a < 0) != (b < 0) ? 1 : 0);
}
std::int64_t floor_mod(std::int64_t a, std::int64_t b) {
  return a - floor_div(a, b) * b;
}

// Levels at a count, from the table in the header of the class, not from its formulas.
Levels table(std::int64_t count, std::int64_t per_rev) {
  static constexpr bool kA[4] = {false, true, true, false};
  static constexpr bool kB[4] = {false, false, true, true};
  const auto phase = static_cast<std::size_t>(floor_mod(count, 4));
  return {kA[phase], kB[phase], floor_mod(count, per_rev) == 0};
}

// Plays one motion cycle by cycle against the count of the exactly interpolated position.
void play(IncrementalEncoder& encoder, std::int64_t per_rev, Cycles from, std::int64_t length, Subcounts start,
          Subcounts target) {
  encoder.move(from, Cycles{length}, target);
  for (std::int64_t d = 1; d <= length; ++d) {
    const Cycles now = from + Cycles{d};
    ASSERT_GE(encoder.next_edge(), now) << "an edge was left behind";
    if (encoder.next_edge() == now) encoder.execute_edge();
    const std::int64_t scaled = start.value() * length + (target - start).value() * d;
    const std::int64_t count = floor_div(2 * scaled + kOne * length, 2 * kOne * length);
    ASSERT_EQ(encoder.count().value(), count) << "cycle " << d << " of " << length;
    ASSERT_EQ(levels(encoder), table(count, per_rev));
  }
  ASSERT_EQ(encoder.next_edge(), kNever);
}

TEST(Encoder, PlacesEveryEdgeOnTheExactCycle) {
  constexpr std::uint64_t kSeed = 42;
  Random random{kSeed};
  IncrementalEncoder encoder{40};
  Subcounts position{};
  Cycles now{0};
  for (int i = 0; i < 4000; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", motion " << i);
    // From creeping to ten counts in 250 cycles, either way; some land exactly on a boundary or just below it.
    const std::int64_t span = kOne * 10 >> random.next() % 30;
    Subcounts target =
        position +
        Subcounts{static_cast<std::int64_t>(random.next() % (2 * static_cast<std::uint64_t>(span) + 1)) - span};
    if (random.chance(0.3)) target = Subcounts{floor_div(target.value(), kOne) * kOne + kOne / 2};
    if (random.chance(0.1)) target -= Subcounts{1};
    play(encoder, 40, now, 250, position, target);
    if (HasFatalFailure()) return;
    position = target;
    now += Cycles{250};
    if (random.chance(0.1)) now += Cycles{static_cast<std::int64_t>(random.next() % 5000)};
  }
}

TEST(Encoder, ObeysTable1InBothDirections) {
  IncrementalEncoder encoder{400};
  Cycles now{0};
  for (const double target : {101.0, -101.0, 0.0}) {
    const bool up = target >= static_cast<double>(encoder.count().value());
    encoder.move(now, Cycles{5000}, at(target));
    while (encoder.next_edge() != kNever) {
      const Levels before = levels(encoder);
      encoder.execute_edge();
      const Levels after = levels(encoder);
      EXPECT_NE(before.a != after.a, before.b != after.b) << "exactly one line changes";
      EXPECT_EQ(after.a != before.b, up) << "direction = a_new XOR b_prev";
    }
    now += Cycles{5000};
  }
}

TEST(Encoder, ShowsItsIndexDuringOneCountPerRevolution) {
  IncrementalEncoder encoder{20};
  encoder.move(Cycles{0}, Cycles{10'000}, at(65.0));
  std::vector<std::int64_t> high;
  if (encoder.z()) high.push_back(0);
  const auto collect = [&] {
    while (encoder.next_edge() != kNever) {
      encoder.execute_edge();
      if (encoder.z()) high.push_back(encoder.count().value());
    }
  };
  collect();
  EXPECT_EQ(high, (std::vector<std::int64_t>{0, 20, 40, 60}));
  high.clear();
  encoder.move(Cycles{10'000}, Cycles{10'000}, at(-45.0));
  collect();
  EXPECT_EQ(high, (std::vector<std::int64_t>{60, 40, 20, 0, -20, -40}));
}

TEST(Encoder, ReversesExactlyAtABoundary) {
  IncrementalEncoder encoder{40};
  encoder.move(Cycles{0}, Cycles{250}, at(1.5));  // ends on the boundary to count 2, which belongs to count 2
  EXPECT_EQ(encoder.next_edge(), Cycles{84});     // 0.5 / 1.5 of 250 is 83.3
  encoder.execute_edge();
  EXPECT_EQ(encoder.next_edge(), Cycles{250});
  encoder.execute_edge();
  EXPECT_EQ(encoder.count().value(), 2);
  encoder.move(Cycles{250}, Cycles{250}, at(1.0));
  EXPECT_EQ(encoder.next_edge(), Cycles{251});  // below the boundary from the first cycle on
  encoder.execute_edge();
  EXPECT_EQ(encoder.count().value(), 1);
  EXPECT_EQ(encoder.next_edge(), kNever);
  encoder.move(Cycles{500}, Cycles{250}, at(1.0));
  EXPECT_EQ(encoder.next_edge(), kNever);
}

TEST(Encoder, StaysBelowABoundaryThatItDoesNotReach) {
  IncrementalEncoder encoder{40};
  encoder.move(Cycles{0}, Cycles{250}, Subcounts{kOne / 2 - 1});
  EXPECT_EQ(encoder.next_edge(), kNever);
  encoder.move(Cycles{250}, Cycles{250}, Subcounts{kOne / 2});
  EXPECT_EQ(encoder.next_edge(), Cycles{500});
}

TEST(Encoder, ShowsFourMillionCountsPerSecondEvenly) {
  IncrementalEncoder encoder{10'000};
  constexpr std::int64_t kCycles = 2500;
  const double counts = 4e6 * kCycles / static_cast<double>(kPlantClockHz);
  ASSERT_EQ(counts, 200.0);
  encoder.move(Cycles{0}, Cycles{kCycles}, at(counts));
  std::vector<std::int64_t> edges;
  while (encoder.next_edge() != kNever) {
    edges.push_back(encoder.next_edge().value());
    encoder.execute_edge();
  }
  ASSERT_EQ(edges.size(), 200u);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    // Ideal place 12.5 (i + 1/2), rounded up to the clock.
    EXPECT_EQ(edges[i], (25 * (2 * static_cast<std::int64_t>(i) + 1) + 3) / 4);
  }
}

TEST(Encoder, RefusesTwoCountsInOneCycle) {
  IncrementalEncoder encoder{40};
  encoder.move(Cycles{0}, Cycles{10}, at(30.0));
  EXPECT_THROW(
      {
        while (encoder.next_edge() != kNever) encoder.execute_edge();
      },
      std::logic_error);
}

TEST(Encoder, RefusesCountsThatAreNoWholeLines) {
  EXPECT_THROW(IncrementalEncoder{0}, std::invalid_argument);
  EXPECT_THROW(IncrementalEncoder{10'001}, std::invalid_argument);
}

TEST(Encoder, RemembersWhichCountsItShowed) {
  IncrementalEncoder encoder{40};
  encoder.move(Cycles{0}, Cycles{100}, at(2.0));  // edges at 25 and 75
  while (encoder.next_edge() != kNever) encoder.execute_edge();
  encoder.move(Cycles{100}, Cycles{100}, at(1.0));  // edge at 151
  encoder.execute_edge();
  const auto range = [&encoder](std::int64_t from) {
    const CountRange counts = encoder.counts_since(Cycles{from});
    return std::pair{counts.min.value(), counts.max.value()};
  };
  EXPECT_EQ(range(151), (std::pair<std::int64_t, std::int64_t>{1, 1}));
  EXPECT_EQ(range(150), (std::pair<std::int64_t, std::int64_t>{1, 2}));
  EXPECT_EQ(range(75), (std::pair<std::int64_t, std::int64_t>{1, 2}));
  EXPECT_EQ(range(25), (std::pair<std::int64_t, std::int64_t>{1, 2}));
  EXPECT_EQ(range(24), (std::pair<std::int64_t, std::int64_t>{0, 2}));
  EXPECT_EQ(range(-5), (std::pair<std::int64_t, std::int64_t>{0, 2}));
}

TEST(Encoder, TellsThePositionBetweenItsEdges) {
  IncrementalEncoder encoder{40};
  encoder.move(Cycles{100}, Cycles{200}, at(3.0));
  EXPECT_EQ(encoder.position(Cycles{100}), 0.0);
  EXPECT_EQ(encoder.position(Cycles{200}), 1.5);
  EXPECT_EQ(encoder.position(Cycles{300}), 3.0);
  EXPECT_EQ(encoder.position(Cycles{900}), 3.0);
}

}  // namespace
}  // namespace armature::cosim
