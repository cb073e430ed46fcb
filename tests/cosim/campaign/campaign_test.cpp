// A campaign finds errors that are planted into the system under test, and shrinks what fails.
#include "cosim/campaign/campaign.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cosim/campaign/shrink.hpp"
#include "cosim/scenario/files/robot_loader.hpp"
#include "tests/cosim/support/scenario_files.hpp"

namespace armature::cosim {
namespace {

CampaignSpec spec_of(std::function<void(Scenario&)> plant_error = {}) {
  CampaignSpec spec{.seed = 1, .robots = {find_robot("kuka_kr6_r900", test::kScenarios)}, .load = test::shipped()};
  spec.load.logic.engine = Engine::kModel;
  spec.plant_error = std::move(plant_error);
  return spec;
}

constexpr const char* kMove = "at_s = 0.01\ntype = \"joint\"\ntarget_deg = ";

CampaignCase case_with(const std::string& fault) {
  CampaignCase drawn{.description = "planted", .robot = "kuka_kr6_r900", .duration_s = 1};
  drawn.keys = "drop_out_us = 500\n";
  for (const char* target :
       {"[1, 1, 1, 1, 1, 1]\n", "[-1, -1, -1, -1, -1, -1]\n", "[20, 0, 0, 0, 0, 0]\n", "[0, 10, 0, 0, 0, 0]\n"}) {
    drawn.steps.push_back(std::string{kMove} + target);
  }
  drawn.faults.push_back("at_s = 0.15\n" + fault);
  return drawn;
}

Outcome outcome_of(const CampaignSpec& spec, const std::string& fault) {
  const test::TempFolder folder;
  const CampaignResult result = run_case(spec, case_with(fault), folder.path());
  EXPECT_EQ(result.faults.size(), 1u) << result.verdict.reason;
  return result.verdict.outcome;
}

// Of the checks of a motor, only following_error_deg is left.
void drop_monitors(AxisSpec& axis) {
  axis.following_error_at_rest_deg.reset();
  axis.encoder_speed_limit_deg_s.reset();
  axis.encoder_accel_limit_deg_s2.reset();
}

// Without feedback, only the following error shows that the drive has missed pulses.
TEST(Campaign, FindsThatTheFollowingErrorIsNotChecked) {
  const std::string lost = "kind = \"pulse_loss\"\naxis = 1\ncount = 20000\n";
  const auto without_feedback = [](Scenario& scenario) {
    scenario.controller.feedback = false;
    std::ranges::for_each(scenario.robot.axes, drop_monitors);
  };
  EXPECT_EQ(outcome_of(spec_of(without_feedback), lost), Outcome::kStopped);
  const auto unchecked = [&](Scenario& scenario) {
    without_feedback(scenario);
    for (AxisSpec& axis : scenario.robot.axes) axis.following_error_deg = 170;
  };
  EXPECT_EQ(outcome_of(spec_of(unchecked), lost), Outcome::kTooLate);
}

TEST(Campaign, FindsThatLostPulsesAreNotCorrected) {
  const std::string lost = "kind = \"pulse_loss\"\naxis = 1\ncount = 1000\n";
  EXPECT_EQ(outcome_of(spec_of(), lost), Outcome::kFinished);
  EXPECT_NE(outcome_of(spec_of([](Scenario& scenario) { scenario.controller.feedback = false; }), lost),
            Outcome::kFinished);
}

TEST(Campaign, FindsThatTheRelayOfTheServoPowerIsMissing) {
  const std::string hang = "kind = \"block_hang\"\nclock = \"motion\"\n";
  EXPECT_EQ(outcome_of(spec_of(), hang), Outcome::kStopped);
  EXPECT_EQ(outcome_of(spec_of([](Scenario& scenario) { scenario.drop_out_us.reset(); }), hang), Outcome::kHang);
}

TEST(Campaign, FindsASpeedAboveTheLimit) {
  const test::TempFolder folder;
  const CampaignSpec fast = spec_of([](Scenario& scenario) {
    for (AxisSpec& axis : scenario.robot.axes) {
      drop_monitors(axis);
      axis.max_speed_deg_s *= 2;
      axis.max_accel_deg_s2 *= 4;
      axis.following_error_deg = 60;
      axis.drive.natural_hz *= 3;
      axis.drive.max_speed_rpm *= 3;
      axis.drive.max_torque_nm *= 9;
    }
  });
  CampaignCase drawn = case_with("");
  drawn.faults.clear();
  drawn.steps[kFirstSteps] = std::string{kMove} + "[120, 0, 0, 0, 0, 0]\n";
  EXPECT_EQ(run_case(spec_of(), drawn, folder.path()).verdict.outcome, Outcome::kFinished);
  EXPECT_EQ(run_case(fast, drawn, folder.path()).verdict.outcome, Outcome::kLimitExceeded);
}

TEST(Campaign, ShrinksToWhatStillFails) {
  const CampaignSpec spec = spec_of([](Scenario& scenario) { scenario.controller.feedback = false; });
  CampaignCase drawn = case_with("kind = \"extra_pulses\"\naxis = 2\ncount = 700\n");
  drawn.steps.insert(drawn.steps.begin() + 2, "at_s = 0.01\ntype = \"dwell\"\nduration_s = 0.01\n");
  drawn.faults.push_back(
      "at_s = 0.16\nkind = \"switch_stuck\"\naxis = 4\nswitch = \"home\"\nlevel = 1\nduration_s = 0.01\n");
  const test::TempFolder folder;
  const CampaignResult failing = run_case(spec, drawn, folder.path());
  ASSERT_TRUE(is_silent(failing.verdict.outcome));
  const CampaignResult least = shrink(spec, failing, folder.path());
  EXPECT_EQ(least.verdict.outcome, failing.verdict.outcome);
  ASSERT_EQ(least.drawn.faults.size(), 1u);
  EXPECT_NE(least.drawn.faults[0].find("extra_pulses"), std::string::npos);
  EXPECT_EQ(least.drawn.steps.size(), kFirstSteps + kLastSteps);
  EXPECT_EQ(run_case(spec, least.drawn, folder.path()).verdict.outcome, failing.verdict.outcome);
}

TEST(Campaign, GivesARunTheSameResultAloneAndInItsGroup) {
  const test::TempFolder folder;
  const auto all = run_group(spec_of(), 3, folder.path(), [](std::int64_t) { return true; }, {});
  ASSERT_EQ(all.size(), static_cast<std::size_t>(kGroupRuns));
  EXPECT_EQ(all[0].verdict.outcome, Outcome::kFinished);
  EXPECT_TRUE(all[0].faults.empty());
  EXPECT_EQ(all[5].faults.size(), 2u);
  const auto alone = run_group(spec_of(), 3, folder.path(), [](std::int64_t run) { return run == 20; }, {});
  ASSERT_EQ(alone.size(), 1u);
  EXPECT_EQ(alone[0].run, 20);
  EXPECT_EQ(alone[0].faults, all[2].faults);
  EXPECT_EQ(alone[0].verdict.outcome, all[2].verdict.outcome);
  EXPECT_EQ(alone[0].verdict.latency_ticks, all[2].verdict.latency_ticks);
}

}  // namespace
}  // namespace armature::cosim
