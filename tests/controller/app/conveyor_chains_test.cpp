// Chains of paths on a part, before and behind long programs that are planned in windows.
#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "controller/command/dispatcher.hpp"
#include "tests/controller/support/conveyor_rig.hpp"

namespace armature {
namespace {

using namespace test::conveyor;

constexpr std::uint32_t kLines = 60;

// Short lines in the base frame to the side, from the place above the belt. All of them ask for a rounded corner at
// their end, also the last one.
void add_program(ConveyorRig& conveyor, std::uint32_t first_tag, const Eigen::Vector3d& from_mm) {
  for (std::uint32_t i = 0; i < kLines; ++i) {
    const Eigen::Vector3d to_mm = from_mm + Eigen::Vector3d{i % 2 == 0 ? 0.1 : 0.0, 0.5 * (i + 1), 0.0};
    CartesianMove move = ConveyorRig::line(kBaseFrame, to_mm, Tag{first_tag + i}, 50.0);
    move.blend_mm = 0.1;
    conveyor.program.push_back(move);
  }
}

// Lines of about 1 mm upwards on the part. All of them ask for a rounded corner at their end.
void add_chain_on_part(ConveyorRig& conveyor, std::uint32_t first_tag, std::uint32_t lines) {
  for (std::uint32_t i = 0; i < lines; ++i) {
    const Eigen::Vector3d to_mm{i % 2 == 0 ? 0.2 : 0.0, 0.0, -40.0 - static_cast<double>(i)};
    CartesianMove move = ConveyorRig::line(kConveyorFrame, to_mm, Tag{first_tag + i});
    move.blend_mm = 0.2;
    conveyor.program.push_back(move);
  }
}

// How often each command was executed to its end, or refused.
std::map<std::uint32_t, int> answers(const ConveyorRig& conveyor) {
  std::map<std::uint32_t, int> answers;
  for (const MoveFinished& move : conveyor.rig.finished) ++answers[move.tag.number()];
  for (const MoveRefused& move : conveyor.rig.refusals) ++answers[move.tag.number()];
  return answers;
}

TEST(ConveyorChains, APartIsFollowedBetweenTwoProgramsInWindows) {
  ConveyorRig conveyor{hundred};
  add_program(conveyor, 100, {380, -60, 260});
  add_chain_on_part(conveyor, 200, 3);
  add_program(conveyor, 300, {380, 100, 260});
  conveyor.rig.run(6 * kSecond);
  EXPECT_TRUE(conveyor.rig.refusals.empty());
  EXPECT_EQ(conveyor.ends(), std::vector{PartEnd::kReleased});
  const std::size_t first_on_part = 1 + kLines, behind = first_on_part + 3;
  ASSERT_EQ(conveyor.rig.moves.size(), behind + kLines);
  EXPECT_EQ(conveyor.rig.moves_finished(), static_cast<int>(behind + kLines));
  for (std::size_t i = 1; i < conveyor.rig.moves.size(); ++i) {
    const MoveStarted& move = conveyor.rig.moves[i];
    EXPECT_EQ(move.on_conveyor, i >= first_on_part && i < behind) << i;
    // The arm stands only before and behind the part.
    EXPECT_EQ(move.continues, i != 1 && i != first_on_part && i != behind) << i;
  }
  conveyor.expect_limits_kept();
  conveyor.rig.expect_pulses_conserved();
}

TEST(ConveyorChains, ALongChainOnAPartStopsThereAfterSixteenMoves) {
  constexpr std::uint32_t kMoves = 20;
  ConveyorRig conveyor{hundred};
  add_chain_on_part(conveyor, 100, kMoves);
  conveyor.program.push_back(JointMove{.target = test::degrees({60, 20, 10, 5, 40, -20}), .tag = Tag{200u}});
  conveyor.rig.run(4 * kSecond);
  EXPECT_TRUE(conveyor.rig.refusals.empty());
  EXPECT_EQ(conveyor.ends(), std::vector{PartEnd::kReleased});
  ASSERT_EQ(conveyor.rig.moves.size(), 1u + kMoves + 1u);
  std::vector<std::size_t> stops;
  for (std::size_t i = 1; i <= kMoves; ++i) {
    if (!conveyor.rig.moves[i].continues) stops.push_back(i);
  }
  EXPECT_EQ(stops, (std::vector<std::size_t>{1, 1 + CartesianPlan::kMaxFirstSegments}));
  conveyor.expect_limits_kept();
  conveyor.rig.expect_pulses_conserved();
}

TEST(ConveyorChains, ALostPartDropsTheWholeProgramOnce) {
  ConveyorRig conveyor{hundred};
  add_chain_on_part(conveyor, 200, 2);
  conveyor.program.push_back(WaitInput{.pin = 3, .level = true, .tag = Tag{210u}});
  add_program(conveyor, 300, {380, 100, 260});
  conveyor.rig.move_at(6 * kSecond, {10, 0, 0, 0, 0, 0});
  conveyor.rig.run(8 * kSecond);
  EXPECT_EQ(conveyor.ends(), std::vector{PartEnd::kWindow});
  EXPECT_EQ(conveyor.rig.refusals.size() + conveyor.program.size(), 1u + kLines);
  EXPECT_GT(conveyor.rig.refusals.size(), MoveQueue::kMoves);
  for (const MoveRefused& refusal : conveyor.rig.refusals) EXPECT_EQ(refusal.reason, Refusal::kPartLost);
  for (const auto& [tag, count] : answers(conveyor)) EXPECT_EQ(count, tag == 0 ? 2 : 1) << tag;
  conveyor.expect_limits_kept();
  conveyor.rig.expect_at({10, 0, 0, 0, 0, 0});
}

TEST(ConveyorChains, AStopOnThePartDropsTheWholeProgramOnce) {
  ConveyorRig conveyor{hundred};
  add_chain_on_part(conveyor, 200, 20);
  add_program(conveyor, 300, {380, 100, 260});
  conveyor.rig.submit_at(kSecond * 3 / 2, Stop{});
  conveyor.rig.move_at(4 * kSecond, {10, 0, 0, 0, 0, 0});
  conveyor.rig.run(6 * kSecond);
  EXPECT_EQ(conveyor.ends(), std::vector{PartEnd::kStopped});
  for (const MoveRefused& refusal : conveyor.rig.refusals) EXPECT_EQ(refusal.reason, Refusal::kNotReady);
  EXPECT_GT(conveyor.rig.refusals.size(), MoveQueue::kMoves);
  for (const auto& [tag, count] : answers(conveyor)) EXPECT_EQ(count, tag == 0 ? 2 : 1) << tag;
  conveyor.expect_limits_kept();
  conveyor.rig.expect_at({10, 0, 0, 0, 0, 0});
}

}  // namespace
}  // namespace armature
