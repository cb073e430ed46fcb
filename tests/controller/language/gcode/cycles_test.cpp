#include "controller/language/gcode/execute/cycles.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/controller/language/gcode/parts_rig.hpp"

namespace armature::test {
namespace {

using gcode::ErrorCode;
using gcode::SetMotionControlMode;
using gcode::StraightFeed;
using gcode::StraightTraverse;

struct GcodeCycles : testing::Test, GcodeParts {
  GcodeCycles() {
    coordinates.begin_program({0, 0, 10, 0, 0, 0});
    EXPECT_FALSE(modes.set_feed(block("F100")));
  }
  // Drills the holes of a line to their end.
  std::optional<ErrorCode> drill(std::string_view text) {
    sink.clear();
    const gcode::Block line = block(text);
    modes.set_distances(line);
    const auto problem = code_of(motion.move(line));
    while (cycles.active()) cycles.step();
    return problem;
  }
  // The heights of all motions: rapids and feeds.
  [[nodiscard]] std::vector<std::pair<char, double>> heights() const {
    std::vector<std::pair<char, double>> found;
    for (const gcode::CanonCall& call : sink.calls) {
      if (const auto* rapid = std::get_if<StraightTraverse>(&call)) found.emplace_back('r', rapid->end[2]);
      if (const auto* feed = std::get_if<StraightFeed>(&call)) found.emplace_back('f', feed->end[2]);
    }
    return found;
  }
  using Heights = std::vector<std::pair<char, double>>;
};

TEST_F(GcodeCycles, DrillAtOnceAndRetractToTheStartOrToR) {
  ASSERT_EQ(drill("G81 X1 Z-1 R2"), std::nullopt);
  EXPECT_EQ(heights(), (Heights{{'r', 10}, {'r', 2}, {'f', -1}, {'r', 10}}));
  ASSERT_EQ(drill("G99 X2"), std::nullopt) << "with R and Z of the line before";
  EXPECT_EQ(heights(), (Heights{{'r', 10}, {'r', 2}, {'f', -1}, {'r', 2}}));
  EXPECT_EQ(coordinates.place()[0], 2.0);
  EXPECT_EQ(sink.all<SetMotionControlMode>().size(), 2U) << "exact path, and back";
}

TEST_F(GcodeCycles, DrillInPecks) {
  ASSERT_EQ(drill("G83 X1 Z-3 R2 Q2"), std::nullopt);
  EXPECT_EQ(heights(), (Heights{{'r', 10},
                                {'r', 2},
                                {'f', 0},
                                {'r', 2},
                                {'r', 0.254},
                                {'f', -2},
                                {'r', 2},
                                {'r', -1.746},
                                {'f', -3},
                                {'r', 10}}));
  ASSERT_EQ(drill("G73 X2 Z-1 R2 Q2"), std::nullopt);
  EXPECT_EQ(heights(), (Heights{{'r', 10}, {'r', 2}, {'f', 0}, {'r', 0.254}, {'f', -1}, {'r', 10}}));
}

TEST_F(GcodeCycles, RepeatAlongIncrements) {
  ASSERT_EQ(drill("G91 G81 X1 Z-3 R-5 L3"), std::nullopt);
  const std::vector<StraightFeed> holes = sink.all<StraightFeed>();
  ASSERT_EQ(holes.size(), 3U);
  EXPECT_EQ(holes[2].end[0], 3.0);
  EXPECT_EQ(holes[2].end[2], 2.0) << "3 mm below R, which is 5 mm below the start";
}

TEST_F(GcodeCycles, TapInAndOutWithBothOverridesOff) {
  EXPECT_EQ(drill("G84 X1 Z-3 R2"), ErrorCode::kTapSpindle);
  motion.begin_program();
  spindle.turn(1);
  ASSERT_EQ(drill("G84 X1 Z-3 R2 P0.5"), std::nullopt);
  EXPECT_EQ(heights(), (Heights{{'r', 10}, {'r', 2}, {'f', -3}, {'f', 10}}));
  const std::vector<gcode::StartSpindle> turns = sink.all<gcode::StartSpindle>();
  ASSERT_EQ(turns.size(), 2U);
  EXPECT_FALSE(turns[0].clockwise);
  EXPECT_TRUE(turns[1].clockwise);
  EXPECT_EQ(sink.last<gcode::Dwell>().seconds, 0.5);
  const std::vector<gcode::EnableOverride> switched = sink.all<gcode::EnableOverride>();
  ASSERT_EQ(switched.size(), 4U);
  EXPECT_FALSE(switched[0].on || switched[1].on);
  EXPECT_TRUE(switched[2].on && switched[3].on);
}

TEST_F(GcodeCycles, NeedTheirWordsOnTheFirstLine) {
  EXPECT_EQ(drill("G81 X1 Z-1"), ErrorCode::kCycleClearanceMissing);
  motion.begin_program();
  EXPECT_EQ(drill("G81 X1 R1"), ErrorCode::kCycleDepthMissing);
  EXPECT_EQ(drill("G82 X1 Z-1 R1"), ErrorCode::kWordMissing);
  EXPECT_EQ(drill("G83 X1 Z-1 R1 Q0"), ErrorCode::kWordRange);
  EXPECT_EQ(drill("G81 X1 Z2 R1"), ErrorCode::kCycleDepth);
  EXPECT_EQ(drill("G81 X1 Z-1 R1 A5"), ErrorCode::kCycleRotaryAxis);
  ASSERT_FALSE(modes.set_feed(block("G93 F1")));
  EXPECT_EQ(drill("G81 X1 Z-1 R1"), ErrorCode::kCycleInverseTime);
}

}  // namespace
}  // namespace armature::test
