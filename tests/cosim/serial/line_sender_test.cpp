#include "cosim/serial/line_sender.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/support/split_mix.hpp"

namespace armature::cosim {
namespace {

using testing::ElementsAre;
using Kind = LineItem::Kind;

// Cycle and level of every change of the line.
using Edges = std::vector<std::pair<std::int64_t, bool>>;

Edges run(LineSender& sender) {
  Edges edges;
  bool level = sender.level();
  while (const auto next = sender.next_event()) {
    sender.advance(*next);
    if (std::exchange(level, sender.level()) != level) edges.emplace_back(next->value(), level);
  }
  return edges;
}

// 50 cycles a bit.
constexpr SerialFormat kSenderFormat{.baud = 1'000'000};

TEST(LineSender, AnIdleLineIsHighAndHasNoEvent) {
  LineSender sender{kSenderFormat};
  EXPECT_TRUE(sender.level());
  EXPECT_FALSE(sender.next_event());
}

TEST(LineSender, SendsTheLeastSignificantBitFirstBetweenStartAndStop) {
  LineSender sender{kSenderFormat};
  sender.push({.data = 0b0100'1101}, Cycles{1'000});
  EXPECT_EQ(sender.next_event(), Cycles{1'000});
  // start, 1, 0, 1 1, 0 0, 1, 0, stop
  EXPECT_EQ(run(sender), (Edges{{1'000, false},
                                {1'050, true},
                                {1'100, false},
                                {1'150, true},
                                {1'250, false},
                                {1'350, true},
                                {1'400, false},
                                {1'450, true}}));
}

TEST(LineSender, CharactersFollowEachOtherWithTheWholeStopTime) {
  for (const auto& [half_bits, second] : {std::pair{2, 500}, {3, 525}, {4, 550}}) {
    LineSender sender{{.baud = 1'000'000, .stop_half_bits = half_bits}};
    sender.push({.data = 0xFF}, Cycles{0});
    sender.push({.data = 0xFF}, Cycles{0});
    EXPECT_EQ(run(sender), (Edges{{0, false}, {50, true}, {second, false}, {second + 50, true}}));
  }
}

TEST(LineSender, PutsTheParityBitOfEachKind) {
  using P = SerialParity;
  // Data 0b0000001 of seven bits: the parity bit is at 400..450 and the stop bit follows.
  for (const auto& [parity, bit] :
       {std::pair{P::kEven, true}, {P::kOdd, false}, {P::kMark, true}, {P::kSpace, false}}) {
    for (const bool wrong : {false, true}) {
      LineSender sender{{.baud = 1'000'000, .data_bits = 7, .parity = parity}};
      sender.push({.data = 1, .wrong_parity = wrong}, Cycles{0});
      const std::int64_t high_from = bit != wrong ? 400 : 450;
      EXPECT_EQ(run(sender), (Edges{{0, false}, {50, true}, {100, false}, {high_from, true}}));
    }
  }
}

TEST(LineSender, AMissingStopBitIsFollowedByAHighBit) {
  LineSender sender{kSenderFormat};
  sender.push({.data = 0xFF, .no_stop = true}, Cycles{0});
  sender.push({.data = 0xFF}, Cycles{0});
  EXPECT_EQ(run(sender), (Edges{{0, false}, {50, true}, {450, false}, {500, true}, {550, false}, {600, true}}));
}

TEST(LineSender, ABreakAndAGapLastAsLongAsTheySay) {
  LineSender sender{kSenderFormat};
  sender.push({.kind = Kind::kBreak, .duration = Cycles{12'345}}, Cycles{7});
  sender.push({.kind = Kind::kGap, .duration = Cycles{1'000}}, Cycles{7});
  sender.push({.data = 0xFF}, Cycles{7});
  EXPECT_EQ(run(sender), (Edges{{7, false}, {12'352, true}, {13'402, false}, {13'452, true}}));
}

// 2 % fast: 50 / 1.02 = 49.0196 cycles a bit.
TEST(LineSender, ABaudErrorShortensOrStretchesItsOwnCharacterOnly) {
  LineSender sender{kSenderFormat};
  sender.push({.data = 0xFF, .baud_error_ppm = 20'000}, Cycles{0});
  sender.push({.data = 0xFF}, Cycles{0});
  EXPECT_EQ(run(sender), (Edges{{0, false}, {50, true}, {491, false}, {541, true}}));
}

// 50 MHz / 115200 is no whole number of cycles. The k-th character of ten bits begins at k * 4340.2777.. = 15625 k
// / 36.
TEST(LineSender, AMillionCharactersDoNotDrift) {
  LineSender sender{{.baud = 115'200}};
  constexpr std::int64_t kCharacters = 1'000'000;
  for (int i = 0; i < 4; ++i) sender.push({.data = 0xFF}, Cycles{0});
  std::int64_t character = 0;
  while (character < kCharacters) {
    const Cycles now = *sender.next_event();
    sender.advance(now);
    if (sender.level()) continue;
    ASSERT_EQ(now.value(), (character * 156'250 + 35) / 36) << "character " << character;
    ++character;
    sender.push({.data = 0xFF}, now);
  }
}

TEST(LineSender, ManyChangesOfTheRateDoNotDriftEither) {
  LineSender sender{{.baud = 115'200}};
  constexpr std::int64_t kPairs = 100'000;
  const long double nominal = 10 * 50e6L / 115'200, fast = nominal / 1.013L;
  for (std::int64_t i = 0; i < kPairs; ++i) {
    sender.push({.data = 0xFF, .baud_error_ppm = 13'000}, Cycles{0});
    sender.push({.data = 0xFF}, Cycles{0});
  }
  sender.push({.data = 0xFF}, Cycles{0});
  Cycles last_start{};
  while (const auto now = sender.next_event()) {
    sender.advance(*now);
    if (!sender.level()) last_start = *now;
  }
  EXPECT_NEAR(static_cast<double>(last_start.value()), static_cast<double>((nominal + fast) * kPairs), 1.0);
}

TEST(LineSender, ReportsEachItemOnceWhenItBegins) {
  LineSender sender{kSenderFormat};
  sender.push({.data = 0x41}, Cycles{10});
  sender.push({.data = 0x42}, Cycles{10});
  EXPECT_EQ(sender.waiting(), 2u);
  EXPECT_FALSE(sender.pop_started());
  sender.advance(Cycles{10});
  const auto first = sender.pop_started();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->item.data, 0x41);
  EXPECT_EQ(first->at, Cycles{10});
  EXPECT_FALSE(sender.pop_started());
  EXPECT_EQ(sender.waiting(), 1u);
}

// A late call of advance() does not move the edges that it has missed.
TEST(LineSender, TheLevelDependsOnTheCycleAndNotOnHowOftenItIsAsked) {
  armature::test::SplitMix random{1};
  LineSender often{{.baud = 921'600}}, seldom{{.baud = 921'600}};
  for (int i = 0; i < 50; ++i) {
    const LineItem item{.data = static_cast<std::uint8_t>(random.next()),
                        .baud_error_ppm = static_cast<std::int32_t>(random.below(40'000)) - 20'000};
    often.push(item, Cycles{0});
    seldom.push(item, Cycles{0});
  }
  for (std::int64_t cycle = 0; cycle < 30'000; ++cycle) {
    often.advance(Cycles{cycle});
    if (random.below(40) != 0) continue;
    seldom.advance(Cycles{cycle});
    ASSERT_EQ(often.level(), seldom.level()) << "cycle " << cycle;
  }
}

}  // namespace
}  // namespace armature::cosim
