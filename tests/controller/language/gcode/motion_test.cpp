#include "controller/language/gcode/execute/motion.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/controller/language/gcode/parts_rig.hpp"

namespace armature::test {
namespace {

using gcode::ArcFeed;
using gcode::ErrorCode;
using gcode::SetFeedRate;
using gcode::StraightFeed;
using gcode::StraightTraverse;

struct GcodeMoves : testing::Test, GcodeParts {
  GcodeMoves() {
    coordinates.begin_program({});
    sink.clear();
  }
  // The motion of a line, in its modes.
  std::optional<ErrorCode> move(std::string_view text) {
    gcode::Block line = block(text);
    if (const auto problem = code_of(motion.set_polar(line))) return problem;
    line = block_with_axes(line);
    if (const auto problem = code_of(modes.set_feed(line))) return problem;
    modes.set_units_and_plane(line);
    modes.set_distances(line);
    return code_of(motion.move(line));
  }
  // The executor checks the block after the polar words have become X and Y.
  [[nodiscard]] gcode::Block block_with_axes(gcode::Block line) const {
    EXPECT_FALSE(check_block(line, motion.active()));
    return line;
  }
};

TEST_F(GcodeMoves, StaysTheSameKindWithoutACode) {
  ASSERT_EQ(move("G0 X1"), std::nullopt);
  ASSERT_EQ(move("Y2"), std::nullopt);
  EXPECT_TRUE((sink.made<StraightTraverse, StraightTraverse>()));
  EXPECT_EQ(coordinates.place()[1], 2.0);
  EXPECT_EQ(move("G1 X5"), ErrorCode::kFeedRateZero);
  ASSERT_EQ(move("G80"), std::nullopt);
  EXPECT_EQ(motion.active(), nullptr);
}

TEST_F(GcodeMoves, CountsIncrementsFromThePlace) {
  ASSERT_EQ(move("G0 X1 A5"), std::nullopt);
  ASSERT_EQ(move("G91 G20 X1 A5"), std::nullopt);
  EXPECT_DOUBLE_EQ(coordinates.place()[0], 26.4);
  EXPECT_DOUBLE_EQ(coordinates.place()[3], 10.0) << "degrees";
  EXPECT_EQ(move("G53 X0"), ErrorCode::kG53Incremental);
}

TEST_F(GcodeMoves, MovesInCoordinatesOfTheMachine) {
  ASSERT_FALSE(coordinates.set_data(block("G10 L2 P1 X5 Y6")));
  ASSERT_EQ(move("G53 G0 X1"), std::nullopt);
  EXPECT_EQ(coordinates.place()[0], -4.0);
  EXPECT_EQ(coordinates.machine()[1], 0.0) << "an axis without a word stays";
}

// A half circle of 10 mm in twice a minute: the number counts lengths of the path.
TEST_F(GcodeMoves, MakesTheFeedOfEachMotionWithInverseTime) {
  ASSERT_EQ(move("G93 G2 X20 I10 F2"), std::nullopt);
  EXPECT_NEAR(sink.last<SetFeedRate>().mm_min, 20.0 * std::numbers::pi, 1e-9);
  ASSERT_EQ(move("G1 A30 F2"), std::nullopt);
  EXPECT_DOUBLE_EQ(sink.last<SetFeedRate>().number, 60.0) << "only A, B and C turn";
  EXPECT_EQ(move("G1 X0"), ErrorCode::kFeedRateMissing);
}

TEST_F(GcodeMoves, FindsTheCentreFromARadiusOrFromWords) {
  ASSERT_EQ(move("G2 X10 R5 F10"), std::nullopt);
  EXPECT_NEAR(sink.last<ArcFeed>().first_axis, 5.0, 1e-6);
  EXPECT_EQ(sink.last<ArcFeed>().rotation, -1);
  ASSERT_EQ(move("G90.1 G3 X0 I5 J0 P3"), std::nullopt);
  EXPECT_EQ(sink.last<ArcFeed>().first_axis, 5.0);
  EXPECT_EQ(sink.last<ArcFeed>().rotation, 3);
  ASSERT_EQ(move("G91.1 G18 G2 X4 Z4 K4 Y1"), std::nullopt);
  EXPECT_EQ(sink.last<ArcFeed>().first_end, 4.0) << "Z is the first axis of G18";
  EXPECT_EQ(sink.last<ArcFeed>().axis_end, 1.0);
}

TEST_F(GcodeMoves, RefusesAnArcWhoseCentreIsNotGiven) {
  EXPECT_EQ(move("G2 X10 F10"), ErrorCode::kArcWithoutCentre);
  EXPECT_EQ(move("G2 X10 I5 R5"), ErrorCode::kWordNotUsed);
  EXPECT_EQ(move("G2 Z1 R5"), ErrorCode::kArcEndMissing);
  EXPECT_EQ(move("G2 X10 I5 K1"), ErrorCode::kArcWrongOffset);
  EXPECT_EQ(move("G90.1 G2 X10 I5"), ErrorCode::kArcCentreMissing);
  EXPECT_EQ(move("G2 X10 I5 J0 P101"), ErrorCode::kWordRange);
  EXPECT_TRUE(sink.all<ArcFeed>().empty());
}

TEST_F(GcodeMoves, TakesPolarWordsForXAndY) {
  ASSERT_EQ(move("G0 X3 Y4"), std::nullopt);
  ASSERT_EQ(move("G0 @10"), std::nullopt);
  EXPECT_NEAR(coordinates.place()[0], 6.0, 1e-12);
  EXPECT_NEAR(coordinates.place()[1], 8.0, 1e-12);
  ASSERT_EQ(move("G0 ^90"), std::nullopt);
  EXPECT_NEAR(coordinates.place()[1], 10.0, 1e-12);
  ASSERT_EQ(move("G91 G0 @-5 ^90"), std::nullopt);
  EXPECT_NEAR(coordinates.place()[0], -5.0, 1e-12);
  EXPECT_NEAR(coordinates.place()[1], 0.0, 1e-12);
  EXPECT_EQ(move("G0 @1 X1"), ErrorCode::kPolarWithAxis);
}

TEST_F(GcodeMoves, GoesHomeByAPlaceWithTheAxesOfTheLine) {
  ASSERT_EQ(move("G0 X1 Y2 Z3"), std::nullopt);
  coordinates.store_home(gcode::kHomeParameter);
  ASSERT_EQ(move("G0 X9 Y9 Z9"), std::nullopt);
  sink.clear();
  motion.go_home(block("G28 Z20"), gcode::kHomeParameter);
  ASSERT_TRUE((sink.made<StraightTraverse, StraightTraverse>()));
  EXPECT_EQ(sink.all<StraightTraverse>()[0].end[2], 20.0);
  EXPECT_EQ(coordinates.place()[2], 3.0);
  EXPECT_EQ(coordinates.place()[0], 9.0);
  motion.go_home(block("G28"), gcode::kHomeParameter);
  EXPECT_EQ(coordinates.place()[0], 1.0);
}

}  // namespace
}  // namespace armature::test
