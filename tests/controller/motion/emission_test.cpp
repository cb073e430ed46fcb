#include "controller/motion/emission.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace armature {
namespace {

PerAxis<Pulses> all(std::int64_t count) {
  PerAxis<Pulses> counts;
  counts.fill(Pulses{count});
  return counts;
}

constexpr bool kPending = true;

// What axis 1 emitted in each tick that has ended.
std::vector<std::int64_t> observe(Emission& emission, std::uint16_t sequence, std::uint32_t underruns,
                                  bool pending = false) {
  std::vector<std::int64_t> ended;
  emission.observe(sequence, pending, underruns,
                   [&](const PerAxis<Pulses>& counts) { ended.push_back(counts[0].value()); });
  return ended;
}

using Ended = std::vector<std::int64_t>;

// Five pulses leave in this tick, six wait under the number 2.
Emission with_waiting_set() {
  Emission emission;
  emission.committed(all(5), 1);
  (void)observe(emission, 1, 0);
  emission.committed(all(6), 2);
  return emission;
}

TEST(Emission, ASetIsEmittedInTheTickAfterItsTrigger) {
  Emission emission;
  emission.committed(all(5), 1);
  EXPECT_EQ(observe(emission, 1, 0), Ended{0});
  emission.committed(all(6), 2);
  EXPECT_EQ(observe(emission, 2, 0), Ended{5});
  emission.committed(all(7), 3);
  EXPECT_EQ(observe(emission, 3, 0), Ended{6});
}

TEST(Emission, ALateSetIsEmittedOneTickLater) {
  Emission emission;
  emission.committed(all(5), 1);
  (void)observe(emission, 1, 0);
  emission.committed(all(6), 2);                           // after its trigger
  EXPECT_EQ(observe(emission, 1, 1, kPending), Ended{5});  // the tick after the set before was empty
  EXPECT_EQ(observe(emission, 2, 0), Ended{0});
  emission.committed(all(7), 3);
  EXPECT_EQ(observe(emission, 3, 0), Ended{6});
}

TEST(Emission, OversleptTicksAreEmpty) {
  Emission emission = with_waiting_set();
  EXPECT_EQ(observe(emission, 2, 3), (Ended{5, 6, 0, 0}));
}

TEST(Emission, IsUncertainAfterASetThatNobodyKnows) {
  Emission emission = with_waiting_set();
  EXPECT_FALSE(emission.uncertain());
  EXPECT_EQ(observe(emission, 77, 0), Ended{5});  // it has replaced the set of 6
  EXPECT_TRUE(emission.uncertain());
  emission.committed(all(7), 3);
  EXPECT_EQ(observe(emission, 3, 0), Ended{0});  // in truth as many as the unknown set had
  EXPECT_TRUE(emission.uncertain());
  emission.committed(all(8), 4);
  EXPECT_EQ(observe(emission, 4, 0), Ended{7});
  EXPECT_FALSE(emission.uncertain());
}

TEST(Emission, NothingEndsWithoutATrigger) {
  Emission emission;
  emission.committed(all(5), 1);
  EXPECT_EQ(observe(emission, 0, 0, kPending), Ended{});
  EXPECT_TRUE(emission.is_waiting());
  EXPECT_FALSE(emission.uncertain());
}

TEST(Emission, ALostSetDoesNotWaitAndMakesItUncertain) {
  Emission emission = with_waiting_set();
  EXPECT_EQ(observe(emission, 1, 1), Ended{5});
  EXPECT_FALSE(emission.is_waiting());
  EXPECT_TRUE(emission.uncertain());
  emission.committed(all(7), 3);
  EXPECT_EQ(observe(emission, 3, 0), Ended{0});
}

TEST(Emission, ASetUnderTheNumberOfTheOneBeforeHasEndedItsTick) {
  Emission emission = with_waiting_set();
  EXPECT_EQ(observe(emission, 1, 0), Ended{5});
  EXPECT_FALSE(emission.is_waiting());
  EXPECT_TRUE(emission.uncertain());
  emission.committed(all(7), 3);
  EXPECT_EQ(observe(emission, 3, 0), Ended{0});  // in truth 6
  EXPECT_TRUE(emission.uncertain());
}

TEST(Emission, IsUncertainWhileASetWaitsThatWasNotCommitted) {
  Emission emission;
  emission.committed(all(5), 1);
  EXPECT_EQ(observe(emission, 1, 0, kPending), Ended{0});
  EXPECT_FALSE(emission.is_waiting());  // the next one may be committed
  EXPECT_TRUE(emission.uncertain());
  emission.committed(all(6), 2);
  EXPECT_EQ(observe(emission, 2, 0), Ended{5});
  emission.committed(all(7), 3);
  EXPECT_EQ(observe(emission, 3, 0), Ended{6});
  EXPECT_FALSE(emission.uncertain());
}

TEST(Emission, ResetForgetsWhatWaits) {
  Emission emission;
  emission.committed(all(5), 1);
  (void)observe(emission, 1, 0);
  emission.reset();
  emission.committed(all(0), 2);
  EXPECT_EQ(observe(emission, 2, 0), Ended{0});
}

}  // namespace
}  // namespace armature
