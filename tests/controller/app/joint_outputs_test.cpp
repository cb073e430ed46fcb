// Outputs at times of joint moves, through the whole controller.
#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "tests/controller/support/output_edges.hpp"

namespace armature {
namespace {

using test::degrees;
using test::Edge;
using test::kPostureDeg;
using test::kThere;
using From = PathOutput::From;
using Unit = PathOutput::Unit;

class JointOutputsTest : public test::OutputEdgesTest {
 protected:
  static JointMove joint_move(double joint_1_deg, double blend_share = 0.0) {
    PerAxis<double> target_deg = kPostureDeg;
    target_deg[0] += joint_1_deg;
    target_deg[2] -= 0.5 * joint_1_deg;
    return {.target = degrees(target_deg), .speed = 0.5, .blend = {.share = blend_share}};
  }
  // The set-point of a move's first tick is reached at the end of the tick after it.
  [[nodiscard]] std::int64_t start_of(std::size_t move) const { return rig.moves.at(move).start_tick.value() + 1; }
};

TEST_F(JointOutputsTest, SwitchInTheTickOfTheirTime) {
  for (const ProfileKind profile : {ProfileKind::kTrapezoid, ProfileKind::kSCurve}) {
    JointMove move = joint_move(profile == ProfileKind::kTrapezoid ? 40 : 0);
    move.profile = profile;
    add(move, 1, profile == ProfileKind::kTrapezoid, From::kStart, Unit::kSeconds, 0.1);
    add(move, 2, profile == ProfileKind::kTrapezoid, From::kEnd, Unit::kSeconds, -0.05);
    add(move, 3, profile == ProfileKind::kTrapezoid, From::kEnd, Unit::kSeconds, 0.0);
    add(move, 4, profile == ProfileKind::kTrapezoid, From::kStart, Unit::kSeconds, 0.0);
    rig.at(kThere, [this, move] { rig.submit(move); });
  }
  watch(30'000);
  ASSERT_TRUE(rig.refusals.empty());
  ASSERT_EQ(edges.size(), 8u);
  for (std::size_t i = 0; i < 2; ++i) {
    const std::int64_t start = start_of(1 + i), end = start + rig.moves[1 + i].duration.value();
    const std::pair<int, std::int64_t> expected[]{{4, start}, {1, start + 2'000}, {2, end - 1'000}, {3, end}};
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_EQ(edges[4 * i + k].pin, expected[k].first);
      EXPECT_EQ(edges[4 * i + k].trigger, expected[k].second) << i << ' ' << k;
      EXPECT_EQ(edges[4 * i + k].level, i == 0);
      EXPECT_EQ(rig.switched.at(4 * i + k).tick, Ticks{expected[k].second});
    }
  }
}

TEST_F(JointOutputsTest, KeepTheirPlaceUnderOverrideAndHold) {
  JointMove there = joint_move(40);
  add(there, 1, true, From::kStart, Unit::kSeconds, 0.15);
  there.tag = 5;
  for (const std::int64_t trigger : {kThere, kThere + 20'000}) {
    rig.submit_at(trigger, there);
    rig.submit_at(trigger + 10'000, joint_move(0));
    rig.at(trigger + 19'000, [this] { rig.submit(SetOutput{.pin = 1, .level = false}); });
  }
  rig.submit_at(kThere + 19'990, SetOverride{.share = 0.3});
  rig.submit_at(kThere + 22'000, Hold{});
  rig.submit_at(kThere + 24'000, Resume{});
  rig.submit_at(kThere + 26'000, Hold{});
  rig.submit_at(kThere + 26'100, Resume{});
  watch(70'000);
  ASSERT_TRUE(rig.refusals.empty());
  std::vector<Edge> rising;
  for (const Edge& edge : edges) {
    if (edge.level) rising.push_back(edge);
  }
  ASSERT_EQ(rising.size(), 2u);
  const auto tool_at = [&](const Edge& edge) { return tool_mm.at(static_cast<std::size_t>(edge.trigger)); };
  const auto first = static_cast<std::size_t>(rising[0].trigger);
  EXPECT_EQ(rising[0].trigger, start_of(1) + 3'000);
  EXPECT_GT(rising[1].trigger, start_of(3) + 9'000);
  // Half a tick's travel at the full rate, and the resolution of the pulses.
  const double travel_mm = (tool_mm.at(first + 1) - tool_mm.at(first)).norm();
  EXPECT_LT((tool_at(rising[1]) - tool_at(rising[0])).norm(), 0.5 * travel_mm + kResolution_mm);
}

TEST_F(JointOutputsTest, OfABlendedMoveCountFromWhereTheNextOneBegins) {
  JointMove first = joint_move(40, 0.5), second = joint_move(0);
  add(first, 1, true, From::kEnd, Unit::kSeconds, 0.0);
  add(first, 2, true, From::kEnd, Unit::kSeconds, 0.02);  // during the second one
  add(second, 3, true, From::kStart, Unit::kSeconds, -0.03);
  add(second, 4, true, From::kEnd, Unit::kSeconds, -0.04);
  rig.at(kThere, [&] {
    rig.submit(first);
    rig.submit(second);
  });
  watch(30'000);
  ASSERT_TRUE(rig.refusals.empty());
  ASSERT_EQ(edges.size(), 4u);
  EXPECT_TRUE(rig.moves[2].continues);
  const std::int64_t start = start_of(2), end = start + rig.moves[2].duration.value();
  const std::pair<int, std::int64_t> expected[]{{3, start - 600}, {1, start}, {2, start + 400}, {4, end - 800}};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(edges[k].pin, expected[k].first);
    EXPECT_EQ(edges[k].trigger, expected[k].second) << k;
  }
}

TEST_F(JointOutputsTest, OneOutsideItsChainRefusesTheChainAndTheNextMoveIsExecuted) {
  JointMove alone = joint_move(40), first = joint_move(40, 0.5), second = joint_move(10), next = joint_move(20);
  add(alone, 1, true, From::kEnd, Unit::kSeconds, 0.001);
  add(second, 2, true, From::kEnd, Unit::kSeconds, 0.001);
  alone.tag = 1, first.tag = 2, second.tag = 3, next.tag = 4;
  for (const JointMove& move : {alone, first, second, next}) rig.at(kThere, [this, move] { rig.submit(move); });
  watch(20'000);
  ASSERT_EQ(rig.refusals.size(), 3u);
  EXPECT_EQ(rig.refusals[0].reason, Refusal::kOutputOutside);
  EXPECT_EQ(rig.refusals[1].reason, Refusal::kChainRefused);
  EXPECT_EQ(rig.refusals[2].reason, Refusal::kOutputOutside);
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(rig.refusals[i].tag, Tag{i + 1});
  EXPECT_TRUE(edges.empty());
  ASSERT_EQ(rig.finished.size(), 2u);
  EXPECT_EQ(rig.moves[1].tag, Tag{4u});
  EXPECT_EQ(rig.rows.back().reference, next.target);
}

TEST_F(JointOutputsTest, DistancesAndOutputsOfMovesThatBeginAtOnceAreRefused) {
  JointMove distance = joint_move(40), at_once = joint_move(40);
  add(distance, 1, true, From::kEnd, Unit::kMm, -1.0);
  add(at_once, 1, true, From::kEnd, Unit::kSeconds, 0.0);
  at_once.now = true;
  rig.submit_at(kThere, distance);
  rig.submit_at(kThere, at_once);
  watch(10'000);
  ASSERT_EQ(rig.refusals.size(), 2u);
  for (const MoveRefused& refusal : rig.refusals) EXPECT_EQ(refusal.reason, Refusal::kInvalidTarget);
}

}  // namespace
}  // namespace armature
