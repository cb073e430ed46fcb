// The table of all expectations, with margins.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cosim/report/judge/expect.hpp"

namespace armature::cosim {
namespace {

ExpectResult only_result(const ExpectSpec& expect, const RunFacts& facts) {
  const auto results = expect_results(expect, facts);
  EXPECT_EQ(results.size(), 1U);
  return results.empty() ? ExpectResult{} : results.front();
}

TEST(ExpectResults, AToleranceHasTheMarginOfTheWorstAxis) {
  RunFacts facts;
  facts.final_joint_deg = {1, 2, 3, 4, 5, 6};
  ExpectSpec expect;
  expect.final_joint_deg = {1, 2.25, 3, 4, 5, 5.875};
  expect.tolerance_deg = 0.5;
  const ExpectResult result = only_result(expect, facts);
  EXPECT_EQ(result.key, "final_joint_deg");
  EXPECT_TRUE(result.met);
  EXPECT_THAT(result.expected, testing::HasSubstr("+-0.5"));
  EXPECT_THAT(result.got, testing::HasSubstr("2, 3"));
  ASSERT_TRUE(result.margin);
  EXPECT_EQ(*result.margin, 0.25);
}

TEST(ExpectResults, ALimitHasTheDistanceToIt) {
  RunFacts facts;
  facts.max_correction_pulses = 7;
  ExpectSpec expect;
  expect.max_correction_pulses = 5;
  const ExpectResult result = only_result(expect, facts);
  EXPECT_FALSE(result.met);
  EXPECT_EQ(result.got, "7");
  ASSERT_TRUE(result.margin);
  EXPECT_EQ(*result.margin, -2);
}

TEST(ExpectResults, WhatMustBeEqualHasNoMargin) {
  ExpectSpec expect;
  expect.underruns = 0;
  const ExpectResult result = only_result(expect, RunFacts{});
  EXPECT_TRUE(result.met);
  EXPECT_EQ(result.got, "0");
  EXPECT_FALSE(result.margin);
}

TEST(ExpectResults, KeysThatAreNotStatedAreNotInTheTable) {
  EXPECT_TRUE(expect_results(ExpectSpec{}, RunFacts{}).empty());
}

}  // namespace
}  // namespace armature::cosim
