// A G-code program through the whole controller: the client of core 1, the dispatcher and the tick.
#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "tests/controller/language/gcode/gcode_rig.hpp"
#include "tests/controller/support/controller_rig.hpp"

namespace armature {
namespace {

using test::kDeg;

constexpr std::int64_t kBegin = 100;

using Kind = ProgramNoted::Kind;
using Note = std::tuple<Kind, std::uint32_t, std::string>;
using Notes = std::vector<Note>;

struct GcodeProgram : testing::Test {
  void start(const std::string& program) {
    const ControllerConfig config{.flange_T_tool = cell.setup.cell.flange_T_tool,
                                  .base_T_user = cell.setup.cell.base_T_user,
                                  .gcode = cell.setup.settings,
                                  .program_start = Ticks{2 * kBegin}};
    const host_memory::BootProgram files{ProgramLanguage::kGcode, {{.name = "a.ngc", .text = program}}};
    rig = std::make_unique<test::ControllerRig>(cell.robot, config, files);
    PerAxis<double> deg{};
    for (std::size_t i = 0; i < kAxes; ++i) deg[i] = cell.joints[i].value() / kDeg;
    rig->move_at(kBegin, deg);
  }
  [[nodiscard]] Eigen::Vector3d tool() const {
    JointAngles joints;
    for (std::size_t i = 0; i < kAxes; ++i) joints[i] = rig->last().reference[i];
    return inverse(*cell.setup.cell.base_T_user[0]) *
           (cell.arm.forward(joints) * cell.setup.cell.flange_T_tool).position_mm;
  }

  [[nodiscard]] Notes notes() const {
    Notes all;
    for (const ProgramNoted& note : rig->notes) all.emplace_back(note.kind, note.place, note.view());
    return all;
  }

  test::Cell cell;
  std::unique_ptr<test::ControllerRig> rig;
};

TEST_F(GcodeProgram, MovesTheToolToItsPlacesAndNamesTheLines) {
  start("G21 G61 F3000\nG0 X0 Y0 Z60\nG1 X30\nG3 X0 Y30 I-30\nM2\n");
  rig->run(60'000);
  ASSERT_TRUE(rig->refusals.empty());
  ASSERT_EQ(rig->moves.size(), 4U);
  for (std::size_t i = 1; i < 4; ++i)
    EXPECT_EQ(rig->moves[i].tag, (Tag{Source::kProgram, static_cast<std::uint32_t>(i + 1)}));
  EXPECT_EQ(rig->moves_finished(), 4);
  EXPECT_NEAR((tool() - Eigen::Vector3d(0.0, 30.0, 60.0)).norm(), 0.0, 1e-6);
  rig->expect_pulses_conserved();
}

TEST_F(GcodeProgram, HoldsTheProgrammedSpeedOverShortLines) {
  // 600 lines of 0.5 mm on a circle at 60 mm/s.
  std::string program = "G21 G64 P0.02 F3600\nG0 X50 Y0 Z60\n";
  constexpr int kSides = 600;
  constexpr double kCircle_mm = 0.5 * kSides / (2.0 * test::kPi);
  for (int i = 1; i <= kSides; ++i) {
    const double angle = 2.0 * test::kPi * i / kSides;
    program += "G1 X" + std::to_string(50.0 - kCircle_mm + kCircle_mm * std::cos(angle)) + " Y" +
               std::to_string(kCircle_mm * std::sin(angle)) + "\n";
  }
  start(program + "M2\n");
  rig->run(220'000);
  ASSERT_TRUE(rig->refusals.empty());
  ASSERT_EQ(rig->moves_finished(), 2 + kSides);
  // 300 mm at 60 mm/s last 5 s; the acceleration to this speed needs 0.03 s at both ends.
  const std::int64_t first = rig->moves[2].start_tick.value();
  const std::int64_t last = rig->finished.back().tick.value();
  EXPECT_LT(static_cast<double>(last - first) * kTickSeconds, 5.15);
}

TEST_F(GcodeProgram, SwitchesOutputsAtTheStartOfMovesWithoutAStop) {
  start("G21 G64 P0.5 F3000\nG0 X0 Y0 Z60\nM62 P0\nG1 X40\nM63 P0\nG1 X80\nM2\n");
  rig->run(60'000);
  ASSERT_TRUE(rig->refusals.empty());
  ASSERT_EQ(rig->switched.size(), 2U);
  EXPECT_TRUE(rig->switched[0].level);
  EXPECT_FALSE(rig->switched[1].level);
  ASSERT_EQ(rig->moves.size(), 4U);
  EXPECT_TRUE(rig->moves[3].continues);
  // 40 mm at 50 mm/s.
  EXPECT_NEAR(static_cast<double>((rig->switched[1].tick - rig->switched[0].tick).value()) * kTickSeconds, 0.8, 0.1);
}

TEST_F(GcodeProgram, DoesNotMoveWhenALineOfTheProgramIsOutOfReach) {
  start("G21 F3000\nG0 X0 Y0 Z60\nG1 X30\nX2000\nM2\n");
  rig->run(30'000);
  EXPECT_EQ(rig->moves.size(), 1U);  // the way to the start
  ASSERT_EQ(notes().size(), 2U);
  EXPECT_EQ(std::get<0>(notes().back()), Kind::kOver);
  const auto [kind, line, text] = notes().front();
  EXPECT_EQ(kind, Kind::kAlarm);
  EXPECT_EQ(line, 4U);
  // The end of the line is 1970 mm further than a place that the arm reaches; no small arm stretches 1 m beyond that.
  constexpr std::string_view kText = "the path leaves the reach of the arm by up to ";
  ASSERT_TRUE(text.starts_with(kText)) << text;
  const int beyond_mm = std::stoi(text.substr(kText.size()));
  EXPECT_GT(beyond_mm, 970);
  EXPECT_LE(beyond_mm, 1970);
  EXPECT_EQ(rig->program().state(), ProgramClient::State::kFailed);
}

TEST_F(GcodeProgram, ReportsItsLinesItsMessagesAndItsEndWhenTheArmStands) {
  start("G21 F3000\n(MSG, hello)\nG0 X0 Y0 Z60\nG1 X30\nM2\n");
  std::optional<MotionState> at_end;
  rig->on_each_trigger = [this, &at_end] {
    const bool ended = !rig->notes.empty() && rig->notes.back().kind == Kind::kEnded;
    if (ended && !at_end && !rig->rows.empty()) at_end = rig->last().state;
  };
  rig->run(60'000);
  EXPECT_EQ(notes(), (Notes{{Kind::kLine, 1, ""},
                            {Kind::kLine, 2, ""},
                            {Kind::kMessage, 2, "hello"},
                            {Kind::kLine, 3, ""},
                            {Kind::kLine, 4, ""},
                            {Kind::kLine, 5, ""},
                            {Kind::kEnded, 5, ""}}));
  EXPECT_EQ(at_end, MotionState::kIdle);
  EXPECT_EQ(rig->program().state(), ProgramClient::State::kEnded);
}

TEST_F(GcodeProgram, HasFailedAtTheLineThatAStopCutsShort) {
  start("G21 G61 F3000\nG0 X0 Y0 Z60\nG1 X80\nM2\n");
  bool stopped = false;
  rig->on_each_trigger = [this, &stopped] {
    if (stopped || rig->moves.size() < 3) return;
    stopped = rig->submit_program(Stop{.kind = Stop::Kind::kSoft});
  };
  rig->run(60'000);
  ASSERT_FALSE(rig->finished.empty());
  EXPECT_EQ(rig->finished.back().how, MoveFinished::How::kCutShort);
  ASSERT_GE(notes().size(), 2U);
  EXPECT_EQ(notes()[notes().size() - 2], (Note{Kind::kStopped, 3, ""}));
  EXPECT_EQ(std::get<0>(notes().back()), Kind::kOver);
  EXPECT_EQ(rig->program().state(), ProgramClient::State::kFailed);
}

}  // namespace
}  // namespace armature
