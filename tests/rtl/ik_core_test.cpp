// ik_core bit for bit against its model: on the reference poses, at the edges, and on random contents of the registers.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/five_r_rig.hpp"
#include "tests/controller/support/reference_data.hpp"
#include "tests/controller/support/six_r_rig.hpp"
#include "tests/rtl/ik_core_fixture.hpp"
#include "tests/support/ik_jobs.hpp"
#include "tests/support/random_ik_jobs.hpp"

namespace armature::test {
namespace {

using nlohmann::json;

// A run of a million takes two minutes: ARMATURE_IK_DRAWS=1000000.
int random_jobs() {
  const char* asked = std::getenv("ARMATURE_IK_DRAWS");
  return asked != nullptr ? std::atoi(asked) : draws(20'000);
}

class IkCore : public IkCoreFixture {};

TEST_F(IkCore, HasTheBitsOfTheModelForTheReferencePosesOfSixAxes) {
  const json reference = read_reference("ik6r_abb_irb120.json");
  const FixedArm arm = fixed_arm(irb120_geometry()).value();
  for (const char* list : {"poses", "edges"}) {
    for (const json& pose : reference[list]) {
      SCOPED_TRACE(pose["T"].dump());
      const Theta previous = pose.contains("prev_theta") ? pose["prev_theta"].get<Theta>() : Theta{};
      expect_the_model(job_of(arm, fixed_pose(transform_of(pose["T"]), arm).value(), previous));
    }
  }
}

TEST_F(IkCore, HasTheBitsOfTheModelForTheReferencePosesOfFiveAxes) {
  const json reference = read_reference("ik5r.json");
  for (const char* list : {"poses", "edges"}) {
    for (const json& pose : reference[list]) {
      SCOPED_TRACE(pose["T"].dump());
      const FixedArm arm = fixed_arm(hu_arm(pose.contains("a1") ? pose["a1"].get<double>() : 1.1)).value();
      expect_the_model(job_of(arm, fixed_pose(transform_of(pose["T"]), arm).value(), {0.3}));
    }
  }
}

TEST_F(IkCore, HasTheBitsOfTheModelAtTheLimitsOfTheReach) {
  ik::Job job = six_r_job();
  for (const bool five_r : {false, true}) {
    job.five_r = five_r;
    for (const std::int32_t reach : {20 * kUnit, 2 * kUnit}) {
      for (std::int32_t beyond = -30; beyond <= 30; ++beyond) {
        SCOPED_TRACE(beyond);
        job.position = {0, 0, reach + beyond * (reach > 10 * kUnit ? 1 : 10)};
        expect_the_model(job);
      }
    }
  }
}

TEST_F(IkCore, HasTheBitsOfTheModelWhereAVectorIsNearlyZero) {
  for (const bool five_r : {false, true}) {
    for (std::int32_t small = -70; small <= 70; small += 5) {
      SCOPED_TRACE(small);
      ik::Job job = six_r_job();
      job.five_r = five_r;
      job.position = {small, -small / 2, 9 * kUnit};  // on axis 1
      expect_the_model(job);
      job.upper = job.fore;
      job.position = {small, 0, small};  // on axis 2
      expect_the_model(job);
      job = six_r_job();
      job.five_r = five_r;
      job.position = {11 * kUnit, 0, 9 * kUnit};
      job.rotation[7] = 12 * small;  // a wrist that is nearly straight
      expect_the_model(job);
    }
  }
  expect_the_model(ik::Job{});
  expect_the_model({.five_r = true});
}

TEST_F(IkCore, HasTheBitsOfTheModelForRandomRegisters) {
  RandomIkJobs jobs{20124};
  const int count = random_jobs();
  for (int i = 0; i < count && !HasFailure(); ++i) {
    SCOPED_TRACE(i);
    expect_the_model(jobs.next());
  }
}

TEST_F(IkCore, SolvesAllBranchesInHalfATick) {
  ik::Job job = six_r_job();
  job.position = {7 * kUnit, 3 * kUnit, 5 * kUnit};
  EXPECT_EQ(run(job), 1241);
  EXPECT_EQ(results().valid, 0xFF);
  job.five_r = true;
  EXPECT_EQ(run(job), 701);
  EXPECT_EQ(results().valid, 0x55);
}

// The inputs may change 26 clocks after the start.
TEST_F(IkCore, CopiesItsInputs) {
  ik::Job job = six_r_job();
  job.position = {7 * kUnit, 3 * kUnit, 5 * kUnit};
  const ik::Solved expected = solve(job);
  set(job);
  start();
  tick(26);
  set({.five_r = true, .rotation = {1, 2, 3, 4, 5, 6, 7, 8, 9}, .a1 = 7, .upper = 5, .previous4 = 5});
  while (dut_.status_busy_o) tick();
  EXPECT_EQ(results().theta, expected.theta);
}

TEST_F(IkCore, IgnoresAStartWhileItIsBusyAndSaysSo) {
  ik::Job job = six_r_job();
  job.position = {7 * kUnit, 3 * kUnit, 5 * kUnit};
  set(job);
  start();
  tick(100);
  EXPECT_FALSE(dut_.status_refused_o);
  set({.five_r = true});
  start();
  tick();
  EXPECT_TRUE(dut_.status_refused_o);
  EXPECT_FALSE(dut_.status_done_o);
  while (dut_.status_busy_o) tick();
  EXPECT_EQ(results().theta, solve(job).theta);
  EXPECT_EQ(dut_.cycles_value_o, 1241);
  EXPECT_TRUE(dut_.status_refused_o);
  start();
  EXPECT_FALSE(dut_.status_refused_o);
}

TEST_F(IkCore, ForgetsTheLastResultsAtAStart) {
  ik::Job job = six_r_job();
  job.position = {7 * kUnit, 3 * kUnit, 5 * kUnit};
  run(job);
  job.position = {100 * kUnit, 0, 0};
  run(job);
  EXPECT_EQ(results().valid, 0);
  for (const std::size_t branch : {0u, 2u, 4u, 6u}) {
    EXPECT_EQ(results().theta[branch], (std::array<std::int32_t, 6>{})) << branch;
  }
}

TEST_F(IkCore, ReportsTheEndOnceAndInterruptsWhileTheEventIsSet) {
  set(six_r_job());
  start();
  int events = 0;
  for (int i = 0; i < 1500; ++i) {
    events += dut_.event_done_set_o;
    tick();
  }
  EXPECT_EQ(events, 1);
  for (const int irq : {0, 1}) {
    for (const int done : {0, 1}) {
      dut_.ctrl_irq_i = static_cast<std::uint8_t>(irq);
      dut_.event_done_i = static_cast<std::uint8_t>(done);
      dut_.eval();
      tick();
      EXPECT_EQ(dut_.irq_o, irq & done);
    }
  }
}

// The bus port requests it for what a write changes. The interrupt follows the event by a clock.
TEST_F(IkCore, NeedsItsClockFromTheStartToTheInterruptOnly) {
  set(six_r_job());
  EXPECT_FALSE(dut_.active_o);
  start();
  int clocks = 0, until_the_event = 0;
  for (; dut_.active_o && clocks < kTimeout; ++clocks) {
    if (dut_.event_done_set_o) until_the_event = clocks;
    tick();
  }
  EXPECT_EQ(until_the_event, dut_.cycles_value_o);
  EXPECT_EQ(clocks, until_the_event + 2);
}

}  // namespace
}  // namespace armature::test
