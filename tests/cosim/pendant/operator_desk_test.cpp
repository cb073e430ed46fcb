#include "cosim/pendant/operator_desk.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <string>

#include "controller/message/fault.hpp"
#include "cosim/pendant/screen.hpp"
#include "tests/cosim/pendant/fake_controller.hpp"

namespace armature::cosim {
namespace {

using pendant::Content;
using pendant::Opcode;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using namespace std::chrono_literals;

struct OperatorDeskTest : testing::Test {
  OperatorDeskTest() {
    robot.axis_count = 6;
    controller.run(link, now, 10ms);
    controller.executed.clear();
  }
  void press(int key) { desk.press(key, now); }
  void run(OperatorLink::Time duration) { controller.run(link, now, duration); }
  [[nodiscard]] std::vector<TerminalLine> screen() const { return screen_lines(desk, "/tmp/arm", 24, 80); }

  OperatorLink::Time now{};
  RobotSpec robot;  // 50 * 10000 / 360 pulses per degree
  test::FakeController controller;
  OperatorLink link{1};
  OperatorDesk desk{
      link, &robot, {{.name = "nod.jbi", .kind = Content::kJob, .text = "NOP\nEND\n", .lines = {"NOP", "END"}}}};
};

TEST_F(OperatorDeskTest, EveryKeyHasItsOwnMeaning) {
  std::set<int> keys;
  for (const OperatorDesk::Key& key : OperatorDesk::keys()) EXPECT_TRUE(keys.insert(key.key).second) << key.shown;
  EXPECT_FALSE(keys.contains(kQuitKey));
}

TEST_F(OperatorDeskTest, AHeldKeyJogsAndAReleasedOneStops) {
  press('d');  // axis 3, negative
  run(500ms);  // a terminal repeats a key late
  for (int i = 0; i < 20; ++i) {
    press('d');
    run(30ms);
  }
  const std::size_t jogs = controller.count(Opcode::kJogContinuous);
  EXPECT_GT(jogs, 35u);
  EXPECT_EQ(controller.executed.front().parameter, 2);
  EXPECT_EQ(controller.executed.front().payload, -10'000);
  EXPECT_EQ(controller.count(Opcode::kJogStop), 0u);
  run(150ms);
  EXPECT_EQ(controller.count(Opcode::kJogStop), 1u);
}

TEST_F(OperatorDeskTest, TheSpaceBarEndsAJogAndStopsTheArm) {
  press('q');
  run(50ms);
  press(' ');
  run(50ms);
  EXPECT_EQ(controller.count(Opcode::kJogStop), 1u);
  EXPECT_EQ(controller.count(Opcode::kStop), 1u);
}

TEST_F(OperatorDeskTest, AStepMovesAnAxisByItsDistance) {
  press('i');
  press('i');
  EXPECT_EQ(desk.step_text(), "0.1 deg / 1 mm");
  press('q');
  controller.set_state(pendant::State::kReady, 256);  // base coordinates
  run(20ms);
  press('s');
  press('g');
  run(20ms);
  ASSERT_EQ(controller.count(Opcode::kJogIncrement), 3u);
  EXPECT_EQ(controller.executed[0].payload, 139);    // 0.1 deg, 1388.9 pulses per degree
  EXPECT_EQ(controller.executed[1].payload, -1000);  // um
  EXPECT_EQ(controller.executed[2].payload, -1000);  // 0.0001 deg
}

TEST_F(OperatorDeskTest, ResetsTheEmergencyStopFirst) {
  controller.set_state(pendant::State::kEstop);
  run(5ms);
  press('z');
  run(20ms);
  ASSERT_EQ(controller.executed.size(), 2u);
  EXPECT_EQ(controller.executed[0].opcode, Opcode::kEstopReset);
  EXPECT_EQ(controller.executed[1].opcode, Opcode::kResetAlarm);
}

TEST_F(OperatorDeskTest, TheScreenShowsPositionsStateAndTheCurrentLine) {
  controller.set_state(pendant::State::kRun, 4096);
  const auto page = [this](std::uint8_t number, std::int32_t value) {
    controller.put(
        {.kind = pendant::Kind::kTelemetry, .opcode = Opcode::kGetStatus, .parameter = number, .payload = value});
  };
  page(1, 13'889);
  page(7, 2);
  page(8, 412'345);
  run(5ms);
  const auto lines = screen();
  EXPECT_THAT(lines, Contains(Field(&TerminalLine::text, HasSubstr("RUN      drives on"))));
  EXPECT_THAT(lines, Contains(Field(&TerminalLine::text, HasSubstr("10.0001"))));
  EXPECT_THAT(lines, Contains(Field(&TerminalLine::text, HasSubstr("412.345 mm"))));
  EXPECT_THAT(lines, Contains(Field(&TerminalLine::text, HasSubstr("EMERGENCY STOP"))));
  EXPECT_THAT(screen_lines(desk, "/tmp/arm", 40, 80), Contains(Field(&TerminalLine::text, HasSubstr(">     2  END"))));
  page(7, 65'536 + 2);  // of another job
  run(5ms);
  EXPECT_EQ(desk.current_line(), 0);
}

TEST_F(OperatorDeskTest, TheArrowsGoToALineThatTheProgramIsRunFrom) {
  press('j');
  for (const int key : {OperatorDesk::kDown, OperatorDesk::kDown, OperatorDesk::kDown}) press(key);
  EXPECT_EQ(desk.cursor(), 2);  // the last one
  press('j');
  EXPECT_EQ(desk.cursor(), 0);
  press(OperatorDesk::kUp);
  EXPECT_EQ(desk.cursor(), 1);
  run(50ms);
  ASSERT_EQ(controller.count(Opcode::kRun), 2u);
  EXPECT_EQ(controller.executed[0].payload, 0);
  EXPECT_EQ(controller.executed[1].payload, 2);
}

TEST_F(OperatorDeskTest, BreakpointsAreSetWhereTheOperatorGoesAndShownWhenTheControllerHasThem) {
  press('b');
  EXPECT_EQ(link.messages().back(), "go to a line of the program first");
  press(OperatorDesk::kDown);
  press(OperatorDesk::kDown);
  press('b');
  EXPECT_FALSE(desk.has_breakpoint(2));
  run(20ms);
  EXPECT_TRUE(desk.has_breakpoint(2));
  EXPECT_THAT(screen(), Contains(Field(&TerminalLine::text, HasSubstr(" *    2  END"))));
  press('b');
  run(20ms);
  EXPECT_FALSE(desk.has_breakpoint(2));
  controller.status = pendant::Status::kRange;
  press('b');
  run(20ms);
  EXPECT_FALSE(desk.has_breakpoint(2));
  std::vector<std::uint8_t> actions;
  for (const auto& command : controller.executed) actions.push_back(command.parameter);
  EXPECT_THAT(actions, testing::ElementsAre(1, 0, 1));
}

TEST_F(OperatorDeskTest, BreakpointsOfALaterJobNameItAndATransferRemovesThem) {
  ASSERT_TRUE(link.download(Content::kJob, "first.jbi", "NOP\nEND\n"));
  run(500ms);
  press(OperatorDesk::kDown);
  press('b');
  EXPECT_EQ(link.messages().back(), "load the program first");
  controller.payload = 1;  // its number
  press('L');
  run(500ms);
  press('b');
  run(20ms);
  EXPECT_TRUE(desk.has_breakpoint(2));
  EXPECT_EQ(controller.executed.back().payload, 65'536 + 2);
  press('B');
  run(20ms);
  EXPECT_FALSE(desk.has_breakpoint(2));
  press('b');
  run(20ms);
  EXPECT_TRUE(desk.has_breakpoint(2));
  press('l');
  run(500ms);
  EXPECT_FALSE(desk.has_breakpoint(2));
}

TEST_F(OperatorDeskTest, RunsTheProgramOnTheScreen) {
  ASSERT_TRUE(link.download(Content::kJob, "first.jbi", "NOP\nEND\n"));
  run(500ms);
  press(OperatorDesk::kEnter);
  EXPECT_EQ(link.messages().back(), "load the program first");
  controller.payload = 1;  // its number
  press('L');
  run(500ms);
  controller.executed.clear();
  press(OperatorDesk::kEnter);
  press('n');
  press(OperatorDesk::kDown);
  press('j');
  run(50ms);
  ASSERT_EQ(controller.executed.size(), 6u);
  for (std::size_t i = 0; i < 6; i += 2) {
    EXPECT_EQ(controller.executed[i].opcode, Opcode::kProgramSelect);
    EXPECT_EQ(controller.executed[i].parameter, 1);
    EXPECT_EQ(controller.executed[i + 1].opcode, Opcode::kRun);
  }
  EXPECT_EQ(controller.executed[3].parameter, 1);  // one line at a time
  EXPECT_EQ(controller.executed[5].payload, 2);
}

TEST_F(OperatorDeskTest, ATransferThatTheControllerRefusesChangesNothing) {
  press('l');
  run(500ms);
  press(OperatorDesk::kDown);
  press('b');
  run(20ms);
  ASSERT_TRUE(desk.has_breakpoint(2));
  press('l');
  run(1ms);                                    // program_begin
  controller.status = pendant::Status::kBusy;  // another one runs the program meanwhile
  run(500ms);
  EXPECT_TRUE(desk.has_breakpoint(2));
  controller.status = pendant::Status::kOk;
  press('l');
  run(1ms);  // program_begin
  controller.status = pendant::Status::kParseError;
  run(500ms);
  EXPECT_FALSE(desk.has_breakpoint(2));
  EXPECT_EQ(link.job_of("nod.jbi"), std::nullopt);
}

TEST_F(OperatorDeskTest, TheScreenFitsTheTerminal) {
  for (std::size_t rows = 1; rows < 60; ++rows) {
    const auto lines = screen_lines(desk, std::string(200, 'x'), rows, 80);
    EXPECT_LE(lines.size(), rows);
    for (const TerminalLine& line : lines) EXPECT_LE(line.text.size(), 80u) << line.text;
  }
}

TEST_F(OperatorDeskTest, TheMessageOfAProgramIsShownWithItsLine) {
  const auto shown = [&] {
    run(200ms);
    const auto lines = screen();
    const auto line =
        std::ranges::find_if(lines, [](const TerminalLine& one) { return one.text.starts_with("line "); });
    return line == lines.end() ? TerminalLine{} : *line;
  };
  EXPECT_THAT(screen(), Contains(Field(&TerminalLine::text, "no message")));
  controller.say(pendant::MessageKind::kMessage, 12, "turn the part");
  EXPECT_EQ(shown().text, "line 12 message: \"turn the part\"");
  EXPECT_EQ(shown().style, TerminalLine::Style::kPlain);
  controller.say(pendant::MessageKind::kAlarm, 65'536 + 7, "no part");
  EXPECT_EQ(shown().text, "line 7 of job 2 alarm: no part");
  EXPECT_EQ(shown().style, TerminalLine::Style::kAlarm);
  controller.say(pendant::MessageKind::kStopped, 9, "");
  EXPECT_EQ(shown().text, "line 9 stopped: the arm did not carry out this line");
  controller.say(pendant::MessageKind::kNone, 0, "");
  EXPECT_EQ(shown().text, "");
}

TEST_F(OperatorDeskTest, AnAlarmIsShownInWords) {
  controller.put({.kind = pendant::Kind::kTelemetry,
                  .opcode = Opcode::kGetStatus,
                  .parameter = 14,
                  .payload = static_cast<std::int32_t>(FaultCause::kDriveAlarm) + 256 * 3});
  run(5ms);
  EXPECT_THAT(screen(), Contains(Field(&TerminalLine::text, HasSubstr("drive alarm, axis 3"))));
}

}  // namespace
}  // namespace armature::cosim
