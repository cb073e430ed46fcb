#include "cosim/scenario/move_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string_view>

#include "cosim/scenario/kinds.hpp"

namespace armature::cosim {
namespace {

// Also those that a later change adds.
TEST(MoveText, EveryKindHasANameOfItsOwnAndItsTextBeginsWithIt) {
  std::set<std::string_view> names;
  for_each_kind<CommandKind>([&]<class Kind>(std::type_identity<Kind>) {
    const std::string_view name = move_entry<Kind>().name;
    EXPECT_FALSE(name.empty());
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_THAT(move_text(Kind{}), testing::StartsWith(std::string{name})) << name;
  });
}

TEST(MoveText, AnOverrideIsShownWithItsShare) {
  EXPECT_EQ(move_text(OverrideSpec{.speed_percent = 30}), "override 30 %");
  EXPECT_EQ(move_text(ClearFaultSpec{}), "clear_fault");
}

TEST(MoveText, MovesAndCommandsForPinsWaitInTheQueueAndAllOthersOvertakeThem) {
  std::set<std::string_view> queued;
  for_each_kind<CommandKind>([&]<class Kind>(std::type_identity<Kind>) {
    if (is_queued(Kind{})) queued.insert(move_entry<Kind>().name);
  });
  EXPECT_THAT(queued, testing::UnorderedElementsAre("joint", "line", "arc", "circle", "arc_about", "spline", "polyline",
                                                    "dwell", "dout", "wait_din"));
}

TEST(CommandSpec, APathHasAPoseAndAJointMoveOnlyWithoutAngles) {
  const CommandKind arc = ArcSpec{.path = {.pose = {.xyz_mm = {1, 2, 3}}, .blend_mm = 4}};
  ASSERT_NE(path_of(arc), nullptr);
  EXPECT_EQ(path_of(arc)->blend_mm, 4);
  EXPECT_EQ(pose_of(arc), &path_of(arc)->pose);

  const CommandKind to_pose = JointSpec{.pose = {.xyz_mm = {1, 2, 3}}};
  EXPECT_EQ(path_of(to_pose), nullptr);
  ASSERT_NE(pose_of(to_pose), nullptr);
  EXPECT_EQ(pose_of(to_pose)->xyz_mm[2], 3);
  EXPECT_EQ(pose_of(JointSpec{.target_deg = PerAxis<double>{}}), nullptr);
  EXPECT_EQ(pose_of(HoldSpec{}), nullptr);
}

}  // namespace
}  // namespace armature::cosim
