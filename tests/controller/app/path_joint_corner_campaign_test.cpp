// Corners between paths of the tool and joint moves: random pairs, and interruptions at many places.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/controller/support/corner_judge.hpp"
#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

using test::Corner;
using test::degrees;
using test::entry_of;
using test::exit_of;
using test::expect_limits;
using test::joint;
using test::kDeg;
using test::kPostureDeg;
using test::kThere;
using test::kTripSecond;
using test::line;
using test::path_limits;
using test::slowest_step;
using test::Trip;

struct Draw {
  std::vector<Command> commands, stopping;
  bool path_first = false;
  bool with_jerk = false;
  double blend = 0.0;  // mm or rad
};

Draw draw_pair(test::Random& random) {
  Draw draw;
  draw.path_first = random.integer(0, 1) == 0;
  const bool path_jerk = random.integer(0, 1) == 0, joint_jerk = random.integer(0, 1) == 0;
  draw.with_jerk = path_jerk && joint_jerk;
  const Eigen::Vector3d way{random.real(-70, 70), random.real(-70, 70), random.real(-70, 70)};
  CartesianMove path = line(way, 0, 1);
  path.limits = path_limits(random.real(80, 500), random.real(800, 6'000));
  path.profile = path_jerk ? ProfileKind::kSCurve : ProfileKind::kTrapezoid;
  PerAxis<double> change;
  for (double& deg : change) deg = random.integer(0, 3) == 0 ? 0.0 : random.real(-35, 35);
  JointMove move = joint(change, 0, 2);
  move.speed = random.real(0.3, 1.0);
  move.profile = joint_jerk ? ProfileKind::kSCurve : ProfileKind::kTrapezoid;
  const auto in_order = [&] {
    return draw.path_first ? std::vector<Command>{path, move} : std::vector<Command>{move, path};
  };
  draw.stopping = in_order();
  draw.blend = draw.path_first ? random.real(1, 15) : random.real(0.5, 8) * kDeg;
  (draw.path_first ? path.blend_mm : move.blend.rad) = draw.blend;
  draw.commands = in_order();
  return draw;
}

TEST(PathJointCornerCampaign, RandomPairsOfBothOrdersKeepLimitsAndDeviationAndAreShorter) {
  test::Random random{71};
  int blended = 0, pairs = 0;
  std::int64_t taken = 0, stopped_taken = 0;
  double used = 0.0;
  for (int i = 0; i < test::draws(40); ++i) {
    const Draw draw = draw_pair(random);
    const std::string what = "seed 71 draw " + std::to_string(i) + (draw.path_first ? " path first" : " joint first");
    const Trip run{draw.commands, 5 * kTripSecond / 2}, stopped{draw.stopping, 5 * kTripSecond / 2};
    if (!run.rig->refusals.empty()) continue;  // out of reach
    ASSERT_EQ(run.moves().size(), 2u) << what;
    ASSERT_EQ(run.rig->last().reference, stopped.rig->last().reference) << what;
    expect_limits(run, draw.with_jerk, what);
    if (HasFatalFailure()) return;
    ++pairs;
    ASSERT_LE(run.taken(), stopped.taken()) << what;
    taken += run.taken();
    stopped_taken += stopped.taken();
    if (!run.moves()[1].continues) continue;
    ++blended;
    const Corner corner = draw.path_first ? exit_of(run, 0) : entry_of(run, 0, stopped);
    ASSERT_LE(corner.missed, draw.blend * (1 + 1e-9)) << what;
    ASSERT_LE(corner.left, draw.blend * 1.02 + 1e-4) << what;
    ASSERT_GT(slowest_step(run, run.started(0) + 1, run.ended(1) - 1), 0.0) << what;
    used += corner.missed / draw.blend;
  }
  EXPECT_GE(pairs, test::least(35));
  EXPECT_GE(blended, pairs * 95 / 100);
  RecordProperty("blended_of_pairs", std::to_string(blended) + " of " + std::to_string(pairs));
  RecordProperty("time_share", std::to_string(static_cast<double>(taken) / static_cast<double>(stopped_taken)));
  EXPECT_LT(static_cast<double>(taken), 0.93 * static_cast<double>(stopped_taken));
  EXPECT_GT(used / blended, 0.8);
}

TEST(PathJointCornerCampaign, HoldsOverridesStopsAndNewTargetsKeepTheLimitsInTheCorners) {
  const auto commands = [] {
    return std::vector<Command>{line({0, 0, -60}, 6, 1), joint({40, 0, 5, 0, 0, 0}, 4, 2), line({0, 0, 60}, 0, 3)};
  };
  const Trip plain{commands()};
  for (const std::size_t corner : {1u, 2u}) {
    for (const std::int64_t beside_corner : {-200, -3, 150}) {
      const std::int64_t at = plain.started(corner) + beside_corner;
      for (const int kind : {0, 1, 2, 3}) {
        Trip run;
        for (const Command& command : commands()) run.rig->submit_at(kThere, command);
        if (kind == 0) run.rig->submit_at(at, Hold{});
        if (kind == 1) run.rig->submit_at(at, SetOverride{.share = 0.3});
        if (kind == 2) run.rig->submit_at(at, Stop{});
        if (kind == 3) run.rig->submit_at(at, JointMove{.target = degrees(kPostureDeg), .now = true, .tag = 4});
        run.rig->submit_at(at + 9'000, Resume{});
        run.rig->run(at + 2 * kTripSecond);
        const std::string what = "kind " + std::to_string(kind) + " at " + std::to_string(at);
        expect_limits(run, false, what);
        EXPECT_EQ(run.rig->moves.size() + run.rig->refusals.size(), kind == 3 ? 5u : 4u) << what;
        EXPECT_EQ(run.rig->moves.size(), run.rig->finished.size()) << what;
        if (kind < 2) {
          EXPECT_EQ(run.rig->last().reference, plain.rig->last().reference) << what;
        }
        if (kind == 3) run.rig->expect_at(kPostureDeg);
        run.rig->expect_pulses_conserved();
        if (HasFatalFailure()) return;
      }
    }
  }
}

}  // namespace
}  // namespace armature
