// The faults of lines change the levels of their line and of no other, on their cycles.
#include "cosim/fault/line_faults.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace armature::cosim {
namespace {

constexpr double kLong = 1;  // [s]

struct Lines {
  Plant plant{RobotSpec{}};
  LineFaults faults{plant, 1};

  [[nodiscard]] SocInputs show(SocInputs pins) const {
    faults.apply_to(pins);
    return pins;
  }
  // The cycles at which something toggles up to `end`.
  std::vector<std::int64_t> events_until(Cycles end) {
    std::vector<std::int64_t> at;
    while (faults.next_event() <= end) {
      at.push_back(faults.next_event().value());
      faults.advance(faults.next_event());
    }
    return at;
  }
};

TEST(LineFaults, HoldALineAtItsLevelUntilTheEnd) {
  Lines lines;
  const EncoderStuck stuck{.axis = 2, .line = EncoderLine::kB, .level = 1, .duration_s = kLong};
  EXPECT_EQ(lines.faults.false_encoders(), 0);
  lines.faults.begin(stuck, Cycles{5});
  EXPECT_EQ(lines.show({}), (SocInputs{.enc_b = 0b10}));
  EXPECT_EQ(lines.faults.next_event(), kNever);
  lines.faults.end(stuck);
  EXPECT_EQ(lines.show({}), SocInputs{});
  EXPECT_EQ(lines.faults.false_encoders(), 0b10);  // the decoder has lost the motor
}

TEST(LineFaults, ABrokenCableTakesAllLinesOfItsEncoder) {
  Lines lines;
  lines.faults.begin(EncoderCable{.axis = 1, .duration_s = kLong}, Cycles{0});
  EXPECT_EQ(lines.show({.enc_a = 3, .enc_b = 3, .enc_z = 3}), (SocInputs{.enc_a = 2, .enc_b = 2, .enc_z = 2}));
}

TEST(LineFaults, OfTheSerialLineTouchNoEncoder) {
  Lines lines;
  lines.faults.begin(UartNoise{.width_us = 0.1, .mean_gap_us = 4, .duration_s = kLong}, Cycles{0});
  EXPECT_EQ(lines.show({}), (SocInputs{.uart_rxd = false}));
  lines.faults.advance(Cycles{5});
  EXPECT_EQ(lines.show({}), SocInputs{});
  lines.faults.end(UartNoise{.width_us = 0.1, .mean_gap_us = 4, .duration_s = kLong});
  lines.faults.begin(UartBreak{.duration_s = kLong}, Cycles{10});
  EXPECT_EQ(lines.show({}), (SocInputs{.uart_rxd = false}));
  EXPECT_EQ(lines.show({.uart_rxd = false}), (SocInputs{.uart_rxd = false}));
  lines.faults.end(UartBreak{.duration_s = kLong});
  EXPECT_EQ(lines.show({}), SocInputs{});
  EXPECT_EQ(lines.faults.false_encoders(), 0);
}

TEST(LineFaults, ExchangeTwoLines) {
  Lines lines;
  lines.faults.begin(EncoderSwapped{.axis = 3, .duration_s = kLong}, Cycles{0});
  EXPECT_EQ(lines.show({.enc_a = 0b100}), (SocInputs{.enc_b = 0b100}));
  EXPECT_EQ(lines.show({.enc_a = 0b011}), (SocInputs{.enc_a = 0b011}));
}

TEST(LineFaults, ChatterInvertsInEachHalfOfItsPeriod) {
  Lines lines;
  lines.faults.begin(EncoderChatter{.axis = 1, .line = EncoderLine::kA, .period_us = 2, .duration_s = kLong},
                     Cycles{100});
  EXPECT_EQ(lines.show({}).enc_a, 1);
  EXPECT_EQ(lines.show({.enc_a = 1}).enc_a, 0);
  EXPECT_EQ(lines.events_until(Cycles{250}), (std::vector<std::int64_t>{150, 200, 250}));
  EXPECT_EQ(lines.show({}).enc_a, 0);
}

TEST(LineFaults, NoiseHasGlitchesOfItsWidthAndGapsOfItsMean) {
  Lines lines;
  lines.faults.begin(
      EncoderNoise{.axis = 1, .line = EncoderLine::kB, .width_us = 0.1, .mean_gap_us = 4, .duration_s = kLong},
      Cycles{0});
  const std::vector<std::int64_t> at = lines.events_until(Cycles{2'050'000});  // 10000 of 5 and 200 cycles
  ASSERT_GT(at.size(), 2u);
  EXPECT_NEAR(static_cast<double>(at.size()), 20'000, 400);
  for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
    const std::int64_t gap = at[i + 1] - at[i];
    EXPECT_GE(gap, 1);
    EXPECT_LE(gap, 400);
    if (i > 0) {
      EXPECT_EQ(at[i] - at[i - 1], 5);
    }
  }
}

TEST(LineFaults, NoiseFollowsTheSeed) {
  const EncoderNoise noise{.axis = 1, .line = EncoderLine::kA, .width_us = 0.1, .mean_gap_us = 4, .duration_s = kLong};
  Plant plant{RobotSpec{}};
  Lines first, same;
  LineFaults other{plant, 2};
  first.faults.begin(noise, Cycles{0});
  same.faults.begin(noise, Cycles{0});
  other.begin(noise, Cycles{0});
  EXPECT_EQ(first.events_until(Cycles{5000}), same.events_until(Cycles{5000}));
  other.advance(other.next_event());
  Lines again;
  again.faults.begin(noise, Cycles{0});
  again.faults.advance(again.faults.next_event());
  EXPECT_NE(other.next_event(), again.faults.next_event());
}

// A decoder follows each step, because only one line changes.
TEST(LineFaults, AMiscountShowsItsCountsOneAfterTheOther) {
  Lines lines;
  lines.faults.begin(EncoderMiscount{.axis = 1, .counts = -3}, Cycles{1000});
  const auto levels = [&] { return lines.show({}).enc_a * 2 + lines.show({}).enc_b; };
  std::vector<int> seen{levels()};
  while (lines.faults.next_event() < kNever) {
    lines.faults.advance(lines.faults.next_event());
    seen.push_back(levels());
  }
  EXPECT_EQ(seen, (std::vector{0b01, 0b11, 0b10}));
}

TEST(LineFaults, TheIndexComesLater) {
  Lines lines;  // all motors stand at the index
  EXPECT_EQ(lines.plant.inputs().enc_z, 0x3F);
  lines.faults.begin(IndexSlip{.axis = 2, .counts = 7}, Cycles{0});
  EXPECT_EQ(lines.show(lines.plant.inputs()).enc_z, 0x3D);
  lines.faults.begin(IndexSlip{.axis = 3, .counts = RobotSpec{}.axes[2].encoder_lines * 4}, Cycles{0});
  EXPECT_EQ(lines.show(lines.plant.inputs()).enc_z, 0x3D);
}

TEST(LineFaults, TheIndexComesLaterInThePositiveDirection) {
  const AxisSpec axis = RobotSpec{}.axes[0];
  const double deg_per_count = 360.0 / (axis.gear_ratio * 4.0 * static_cast<double>(axis.encoder_lines));
  const Plant plant{RobotSpec{}, std::nullopt, {7 * deg_per_count}};
  ASSERT_EQ(plant.motor_counts(0), Counts{7});
  LineFaults faults{plant, 1};
  faults.begin(IndexSlip{.axis = 1, .counts = 7}, Cycles{0});
  SocInputs pins = plant.inputs();
  EXPECT_EQ(pins.enc_z & 1, 0);
  faults.apply_to(pins);
  EXPECT_EQ(pins.enc_z & 1, 1);
}

TEST(LineFaults, SwitchesStickAndBounce) {
  Lines lines;
  lines.faults.begin(SwitchStuck{.axis = 6, .which = AxisSwitch::kHome, .level = 1, .duration_s = kLong}, Cycles{0});
  lines.faults.begin(SwitchBounce{.axis = 1, .which = AxisSwitch::kLimitNeg, .period_us = 2, .duration_s = kLong},
                     Cycles{0});
  EXPECT_EQ(lines.show({}), (SocInputs{.home = 0x20, .limit_neg = 1}));
  lines.faults.advance(Cycles{50});
  EXPECT_EQ(lines.show({}), (SocInputs{.home = 0x20}));
  EXPECT_EQ(lines.faults.false_encoders(), 0);
}

}  // namespace
}  // namespace armature::cosim
