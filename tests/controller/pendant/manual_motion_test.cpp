#include "controller/pendant/parts/manual_motion.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <variant>

#include "tests/controller/support/path_rig.hpp"

namespace armature::pendant {
namespace {

class ManualMotionTest : public testing::Test {
 protected:
  // Stages all coordinates of a point, and returns the check value.
  std::int32_t stage(std::size_t point, std::int32_t value) {
    Crc32 crc;
    for (std::size_t i = 0; i < StagedMove::kCoordinates; ++i) {
      EXPECT_TRUE(manual.stage_target(point * StagedMove::kParametersOfPoint + i, value));
      crc.add(value);
    }
    return crc.check();
  }
  [[nodiscard]] double speed_of_increment() const { return std::get<JointMove>(manual.increment(0, 100, {})).speed; }

  const RobotModel robot = armature::test::irb120();
  const Arm arm{robot};
  const PlanningConfig planning{};
  ManualMotion manual{robot, arm, planning};
};

TEST_F(ManualMotionTest, AStagedMoveIsTakenOnce) {
  const std::int32_t check = stage(0, 500);
  const std::optional<StagedMove> staged = manual.take_staged(1, check);
  ASSERT_TRUE(staged);
  EXPECT_EQ(staged->point(0)[5], 500);
  EXPECT_FALSE(manual.take_staged(1, check));
}

TEST_F(ManualMotionTest, AWrongCheckOrAnotherNumberOfPointsDropsWhatIsStaged) {
  const std::int32_t check = stage(0, 500);
  EXPECT_FALSE(manual.take_staged(1, check + 1));
  EXPECT_FALSE(manual.take_staged(1, check));
  EXPECT_EQ(stage(0, 500), check);
  EXPECT_FALSE(manual.take_staged(2, check));
  EXPECT_FALSE(manual.take_staged(1, check));
}

TEST_F(ManualMotionTest, OtherCoordinatesDropWhatIsStaged) {
  std::int32_t check = stage(0, 500);
  manual.select(System::kBase);
  EXPECT_FALSE(manual.take_staged(1, check));
  check = stage(0, 500);
  manual.select_user(3);
  EXPECT_FALSE(manual.take_staged(1, check));
}

TEST_F(ManualMotionTest, TheJogLimitScalesJogsAndIncrements) {
  manual.press(0, -0.5, Cycles{0});
  const double quarter = manual.jog(Cycles{1}).joint_rad_s[0];
  EXPECT_LT(quarter, 0.0);
  EXPECT_EQ(speed_of_increment(), 0.25);
  manual.set_jog_limit(0.5);
  EXPECT_DOUBLE_EQ(manual.jog(Cycles{1}).joint_rad_s[0], 2.0 * quarter);
  EXPECT_EQ(speed_of_increment(), 0.5);
  manual.release();
  EXPECT_EQ(manual.jog(Cycles{1}).joint_rad_s[0], 0.0);
}

}  // namespace
}  // namespace armature::pendant
