// Half periods against pins, and the position of the one decoder.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

#include "controller/regs/encoder_switch_regs.hpp"
#include "controller/regs/pulse_width_regs.hpp"
#include "tests/cosim/support/conservation_bench.hpp"

namespace armature::cosim {
namespace {

namespace pw = regs::pulse_width;
using ::testing::HasSubstr;

TEST(PaperWidths, ExpectsWhatTheSteppedGeneratorEmits) {
  for (const std::int64_t tick : {2'500, 2'499, 100}) {
    for (std::int32_t width = 1; width < 2'600; ++width) {
      std::int32_t rises = 0;
      bool step = false;
      for (std::int64_t at = width; at < tick; at += width) {
        step = !step;
        rises += step ? 1 : 0;
      }
      PaperWidths widths;
      widths.on_write(2, width, false);
      widths.on_write(3, -width, false);
      widths.on_trigger();
      ASSERT_EQ(widths.expected(2, Cycles{tick}), rises) << width;
      ASSERT_EQ(widths.expected(3, Cycles{tick}), -rises) << width;
      ASSERT_TRUE(widths.allows(2, rises, Cycles{tick}));
      ASSERT_FALSE(widths.allows(2, rises + 1, Cycles{tick}));
      ASSERT_FALSE(widths.allows(2, rises - 1, Cycles{tick}));
    }
  }
}

TEST(PaperWidths, AWidthStandsAndAWriteInDoubtAllowsBoth) {
  PaperWidths widths;
  widths.on_write(0, 100, false);
  EXPECT_TRUE(widths.allows(0, 0, Cycles{2'500}));
  EXPECT_FALSE(widths.allows(0, 12, Cycles{2'500})) << "no trigger has taken it";
  for (int tick = 0; tick < 3; ++tick) {
    widths.on_trigger();
    EXPECT_TRUE(widths.allows(0, 12, Cycles{2'500}));
  }
  widths.on_write(0, 50, true);
  EXPECT_TRUE(widths.allows(0, 12, Cycles{2'500}));
  EXPECT_TRUE(widths.allows(0, 25, Cycles{2'500}));
  widths.on_trigger();
  EXPECT_FALSE(widths.allows(0, 12, Cycles{2'500}));
}

TEST(PaperWidths, AStopMayCutThePulsesOfEachWidthThatMayBeActive) {
  PaperWidths widths;
  widths.on_write(0, -100, false);
  widths.on_trigger();
  EXPECT_EQ(widths.whole_of(0, -7, Cycles{2'500}), -12);
  EXPECT_EQ(widths.whole_of(0, 7, Cycles{2'500}), std::nullopt);
  widths.on_write(0, 0, true);
  EXPECT_EQ(widths.whole_of(0, -7, Cycles{2'500}), -12) << "the width before may be the active one";
  EXPECT_EQ(widths.whole_of(0, 0, Cycles{2'500}), 0);
  EXPECT_EQ(widths.whole_of(0, -13, Cycles{2'500}), std::nullopt);
  widths.on_trigger();
  EXPECT_EQ(widths.whole_of(0, -7, Cycles{2'500}), std::nullopt);
}

// The bench with the registers of the paper's logic. Its pins emit counts; the widths that the software wrote are
// apart.
class PaperConservation : public testing::Test {
 protected:
  void write_widths(const PerAxis<std::int32_t>& widths) {
    for (std::uint32_t axis = 0; axis < kAxes; ++axis) {
      check.on_write(bench.now(), regs::soc::kPulseWidthBase + pw::kWidthOffset + 4 * axis,
                     static_cast<std::uint32_t>(widths[axis]));
    }
  }
  void read_status(std::uint32_t word) {
    check.on_read(bench.now(), regs::soc::kPulseWidthBase + pw::kStatusOffset, word);
  }
  void read_position(std::int64_t value) {
    check.on_read(bench.now(), regs::soc::kEncoderBase + regs::encoder::kPositionOffset,
                  static_cast<std::uint32_t>(value));
  }
  void select(std::uint32_t axis) {
    check.on_write(bench.now(), regs::soc::kEncoderSwitchBase + regs::encoder_switch::kSelectOffset, axis);
  }

  ConservationBench bench{{.paper = true}};
  Conservation& check = bench.check;
};

constexpr PerAxis<std::int32_t> kWidths{125, -250, 0, 7, -8, 1'250};
constexpr CountSet kCounts{10, -5, 0, 179, -156, 1};

TEST_F(PaperConservation, IsSilentWhileEveryTickEmitsWhatItsWidthsMake) {
  select(1);
  bench.begin_tick(kNone);
  write_widths(kWidths);
  for (int tick = 0; tick < 4; ++tick) {  // one write, four ticks
    bench.begin_tick(kCounts);
    read_status(0);
    read_position(bench.position_at_trigger(1));
    for (std::size_t axis = 0; axis < kAxes; ++axis) bench.read_emitted(axis, bench.emitted_at_trigger[axis]);
  }
  write_widths({});
  bench.begin_tick(kNone);
  read_status(0);
  check.finish();
  EXPECT_FALSE(check.violation()) << *check.violation();
  EXPECT_EQ(check.pin_pulses(3), 4 * 179);
}

TEST_F(PaperConservation, CatchesAPulseTooMany) {
  bench.begin_tick(kNone);
  write_widths(kWidths);
  CountSet wrong = kCounts;
  wrong[1] = -6;
  bench.begin_tick(wrong);
  bench.begin_tick(kCounts);
  ASSERT_TRUE(check.violation());
  EXPECT_THAT(*check.violation(), HasSubstr("axis 2"));
  EXPECT_THAT(*check.violation(), HasSubstr("the half period makes -5 pulses, -6 emitted"));
}

TEST_F(PaperConservation, CatchesMissingPulsesThatNoStopExplains) {
  bench.begin_tick(kNone);
  write_widths(kWidths);
  CountSet wrong = kCounts;
  wrong[3] = 178;
  bench.begin_tick(wrong);
  bench.begin_tick(kCounts, 1'500);
  EXPECT_FALSE(check.violation()) << "nobody has asked yet";
  read_status(0);
  ASSERT_TRUE(check.violation());
  EXPECT_THAT(*check.violation(), HasSubstr("179 pulses committed, 178 emitted, and STATUS shows no ESTOP"));
}

TEST_F(PaperConservation, AStopExplainsMissingPulses) {
  bench.begin_tick(kNone);
  write_widths(kWidths);
  bench.begin_tick(kNone);
  bench.begin_tick(kNone, 1'500);
  read_status(pw::kStatusEstopMask);
  write_widths({});
  bench.begin_tick(kNone);
  bench.begin_tick(kNone);
  check.finish();
  EXPECT_FALSE(check.violation()) << *check.violation();
}

TEST_F(PaperConservation, CatchesAWrongEmittedRegister) {
  bench.begin_tick(kNone);
  write_widths(kWidths);
  bench.begin_tick(kCounts);
  bench.begin_tick(kCounts);
  bench.read_emitted(4, bench.emitted_at_trigger[4] + 1);
  ASSERT_TRUE(check.violation());
  EXPECT_THAT(*check.violation(), HasSubstr("EMITTED reads -155"));
}

TEST_F(PaperConservation, PositionIsThatOfTheSelectedAxis) {
  select(4);
  bench.begin_tick(kNone);
  write_widths(kWidths);
  for (int tick = 0; tick < 20; ++tick) bench.begin_tick(kCounts);
  ASSERT_NE(bench.position_at_trigger(4), bench.position_at_trigger(0));
  read_position(bench.position_at_trigger(4));
  EXPECT_FALSE(check.violation()) << *check.violation();
  read_position(bench.position_at_trigger(0));
  ASSERT_TRUE(check.violation());
  EXPECT_THAT(*check.violation(), HasSubstr("axis 5"));
  EXPECT_THAT(*check.violation(), HasSubstr("POSITION reads"));
}

TEST_F(PaperConservation, ASwitchThatIsTurnedLeavesASumThatNobodyChecks) {
  bench.begin_tick(kNone);
  select(2);
  bench.begin_tick(kNone);
  read_position(12'345);
  EXPECT_FALSE(check.violation());
}

}  // namespace
}  // namespace armature::cosim
