#include "cosim/iss/debug/stop_rules.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace armature::cosim::iss {
namespace {

using PointKind = StopPoint::Kind;

Stop::Why why(const std::optional<Stop>& stop) {
  return stop.value().why;
}

TEST(StopRules, StopEachCoreAtABreakpoint) {
  StopRules rules;
  EXPECT_FALSE(rules.active());
  rules.set({}, std::vector<StopPoint>{{PointKind::kBreakpoint, 0x1000, 4}});
  EXPECT_TRUE(rules.active());
  EXPECT_FALSE(rules.at_instruction(0, 0x1004));
  EXPECT_FALSE(rules.at_instruction(0, 0x1000 + 2 * 4096));  // may have the same bit of the filter
  for (const int core : {0, 1}) {
    EXPECT_EQ(why(rules.at_instruction(core, 0x1000)), Stop::Why::kPoint);
    EXPECT_EQ(rules.at_instruction(core, 0x1000)->core, core);
  }
}

TEST(StopRules, StepOneCoreWhileTheOtherExecutes) {
  StopRules rules;
  rules.set({.how = Resume::How::kStep, .core = 1}, {});
  EXPECT_FALSE(rules.at_instruction(0, 0x1000));
  EXPECT_EQ(why(rules.at_instruction(1, 0x1000)), Stop::Why::kStep);
}

TEST(StopRules, StepAcrossARange) {
  StopRules rules;
  rules.set({.how = Resume::How::kStep, .core = 0, .first = 0x1000, .last = 0x1008}, {});
  EXPECT_FALSE(rules.at_instruction(0, 0x1004));
  EXPECT_EQ(why(rules.at_instruction(0, 0x1008)), Stop::Why::kStep);
  EXPECT_EQ(why(rules.at_instruction(0, 0x0ffc)), Stop::Why::kStep);
}

TEST(StopRules, StopEitherCoreWhenInterrupted) {
  StopRules rules;
  rules.set({}, {});
  EXPECT_FALSE(rules.active());
  rules.interrupt();
  EXPECT_TRUE(rules.active());
  EXPECT_EQ(why(rules.at_instruction(1, 0x1000)), Stop::Why::kInterrupt);
}

TEST(StopRules, WatchTheAccessesOfTheirKind) {
  constexpr DataAccess kWrite{.address = 0x2004, .bytes = 4, .write = true};
  constexpr DataAccess kRead{.address = 0x2004, .bytes = 4, .write = false};
  const auto stops = [](PointKind kind, const DataAccess& access) {
    StopRules rules;
    rules.set({}, std::vector<StopPoint>{{kind, 0x2000, 8}});
    return rules.at_data(0, access).has_value();
  };
  EXPECT_TRUE(stops(PointKind::kWrite, kWrite));
  EXPECT_FALSE(stops(PointKind::kWrite, kRead));
  EXPECT_FALSE(stops(PointKind::kRead, kWrite));
  EXPECT_TRUE(stops(PointKind::kRead, kRead));
  EXPECT_TRUE(stops(PointKind::kAccess, kWrite));
  EXPECT_TRUE(stops(PointKind::kAccess, kRead));
}

TEST(StopRules, WatchAccessesThatOverlapInAByte) {
  StopRules rules;
  rules.set({}, std::vector<StopPoint>{{PointKind::kWrite, 0x2002, 1}});
  EXPECT_EQ(rules.at_data(0, {.address = 0x2000, .bytes = 4, .write = true})->data, 0x2002u);
  EXPECT_EQ(rules.at_data(0, {.address = 0x2002, .bytes = 1, .write = true})->data, 0x2002u);
  EXPECT_FALSE(rules.at_data(0, {.address = 0x2003, .bytes = 1, .write = true}));
  EXPECT_FALSE(rules.at_data(0, {.address = 0x2000, .bytes = 2, .write = true}));
}

TEST(StopRules, ForgetWhatWasSetBefore) {
  StopRules rules;
  rules.set({.how = Resume::How::kStep}, std::vector<StopPoint>{{PointKind::kBreakpoint, 0x1000, 4}});
  rules.set({}, {});
  EXPECT_FALSE(rules.at_instruction(0, 0x1000));
}

}  // namespace
}  // namespace armature::cosim::iss
