// Joint moves that begin at once, at random times: limits, pulses and the last target of many runs.
#include <gtest/gtest.h>

#include <string>

#include "tests/controller/support/controller_rig.hpp"
#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/controller/support/retarget_rig.hpp"

namespace armature {
namespace {

using test::ControllerRig;
using test::degrees;
using test::expect_limits;
using test::kDeg;
using test::kPathLimits;
using test::now_to;
using test::robot_to_retarget;

constexpr std::int64_t kSecondTicks = 20'000;

TEST(RetargetCampaign, AtRandomTimesOverJointMovesAndPathsKeepsTheLimits) {
  test::Random random{51};
  for (int draw = 0; draw < test::draws(30); ++draw) {
    ControllerRig rig{robot_to_retarget()};
    const ProfileKind kinds[] = {ProfileKind::kTrapezoid, ProfileKind::kSCurve};
    const auto kind = [&] { return kinds[random.integer(0, 1)]; };
    rig.move_at(10, {0, 20, -30, 0, 40, 0});
    std::int64_t at = kSecondTicks;
    if (random.integer(0, 1) == 0) {
      CartesianMove line{.target = {.frame = kToolFrame, .position_mm = {0, random.real(50, 150), 80}},
                         .profile = kind()};
      line.limits = kPathLimits;
      rig.submit_at(at, line);
    } else {
      rig.submit_at(at, JointMove{.target = degrees({60, -20, 20, 40, 10, -50}), .profile = kind()});
    }
    if (random.integer(0, 2) == 0) rig.submit_at(at - 1, SetOverride{.share = random.real(0.5, 1.0)});
    PerAxis<double> last{};
    for (int i = 0; i < 4; ++i) {
      at += random.integer(200, 6'000);
      for (double& deg : last) deg = random.real(-90, 90);
      JointMove move = now_to(last);
      move.profile = kind();
      move.speed = random.real(0.5, 1.0);
      rig.submit_at(at, move);
    }
    rig.run(at + 4 * kSecondTicks);
    const std::string what = "seed 51 draw " + std::to_string(draw);
    EXPECT_TRUE(rig.refusals.empty()) << what;
    expect_limits(rig, what);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      ASSERT_EQ(rig.last().reference[axis].value(), last[axis] * kDeg) << what;
    }
    rig.expect_pulses_conserved();
    if (testing::Test::HasFatalFailure()) return;
  }
}

// Each command starts or is refused once, whatever comes when, and the arm can move afterwards.
TEST(RetargetCampaign, AnySequenceWithStopsHoldsAndMovesEndsWithTheLastMove) {
  test::Random random{52};
  for (int draw = 0; draw < test::draws(30); ++draw) {
    ControllerRig rig{robot_to_retarget()};
    std::uint32_t moves = 0;
    std::int64_t at = 10;
    for (int i = 0; i < 30; ++i, at += random.integer(1, 300)) {
      const double deg = random.real(-3, 3);
      switch (random.integer(0, 5)) {
        case 0:
          rig.submit_at(at, Stop{});
          break;
        case 1:
          rig.submit_at(at, Hold{});
          break;
        case 2:
          rig.submit_at(at, Resume{});
          break;
        case 3:
          rig.submit_at(at, JointMove{.target = degrees({deg, deg, 0, 0, 0, 0}), .tag = ++moves});
          break;
        default:
          rig.submit_at(at, now_to({deg, 0, deg, 0, 0, 0}, ++moves));
      }
    }
    rig.submit_at(at + 1, Resume{});
    rig.submit_at(at + 2, JointMove{.target = degrees({1, 2, 3, 0, 0, 0}), .tag = ++moves});
    rig.run(at + 4 * kSecondTicks);
    EXPECT_EQ(rig.moves.size() + rig.refusals.size(), moves) << "seed 52 draw " << draw;
    EXPECT_EQ(rig.moves.size(), rig.finished.size()) << "seed 52 draw " << draw;
    rig.expect_at({1, 2, 3, 0, 0, 0});
    expect_limits(rig, "seed 52 draw " + std::to_string(draw));
    rig.expect_pulses_conserved();
  }
}

}  // namespace
}  // namespace armature
