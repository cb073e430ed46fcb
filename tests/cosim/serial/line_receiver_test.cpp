#include "cosim/serial/line_receiver.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "cosim/serial/line_sender.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::cosim {
namespace {

// Levels from given cycles on, run to the end.
std::vector<ReceivedCharacter> receive(const SerialFormat& format, const std::vector<std::pair<int, bool>>& changes) {
  LineReceiver receiver{format};
  std::vector<ReceivedCharacter> characters;
  const auto take = [&] {
    if (const auto character = receiver.pop()) characters.push_back(*character);
  };
  const auto advance_until = [&](Cycles limit) {
    for (auto next = receiver.next_event(); next && *next < limit; next = receiver.next_event()) {
      receiver.advance(*next);
      take();
    }
  };
  for (const auto& [cycle, level] : changes) {
    advance_until(Cycles{cycle});
    receiver.on_level(Cycles{cycle}, level);
    take();
  }
  advance_until(Cycles{1'000'000'000});
  return characters;
}

// 50 cycles a bit.
constexpr SerialFormat kReceiverFormat{.baud = 1'000'000};

TEST(LineReceiver, AnIdleLineHasNoEvent) {
  const LineReceiver receiver{kReceiverFormat};
  EXPECT_FALSE(receiver.next_event());
}

TEST(LineReceiver, TellsACharacterInTheMiddleOfItsStopBit) {
  // 'A' = 0b0100'0001: start, 1, 0 0 0 0 0, 1, 0, stop
  const auto got = receive(
      kReceiverFormat, {{1'000, false}, {1'050, true}, {1'100, false}, {1'350, true}, {1'400, false}, {1'450, true}});
  ASSERT_EQ(got.size(), 1u);
  EXPECT_EQ(got[0].data, 'A');
  EXPECT_EQ(got[0].start, Cycles{1'000});
  EXPECT_EQ(got[0].end, Cycles{1'475});
  EXPECT_FALSE(got[0].parity_error || got[0].framing_error || got[0].is_break);
}

// A bit counts as what it is in its middle: an edge on the sampling cycle already counts, one behind it does not.
TEST(LineReceiver, SamplesInTheMiddle) {
  EXPECT_EQ(receive(kReceiverFormat, {{0, false}, {74, true}})[0].data, 0xFF);
  EXPECT_EQ(receive(kReceiverFormat, {{0, false}, {75, true}})[0].data, 0xFF);
  EXPECT_EQ(receive(kReceiverFormat, {{0, false}, {76, true}})[0].data, 0xFE);
  EXPECT_EQ(receive(kReceiverFormat, {{0, false}, {125, true}})[0].data, 0xFE);
  EXPECT_EQ(receive(kReceiverFormat, {{0, false}, {126, true}})[0].data, 0xFC);
}

TEST(LineReceiver, AStartBitThatIsHighInItsMiddleWasNone) {
  EXPECT_TRUE(receive(kReceiverFormat, {{0, false}, {24, true}}).empty());
  EXPECT_EQ(receive(kReceiverFormat, {{0, false}, {26, true}}).size(), 1u);
  const auto after = receive(kReceiverFormat, {{0, false}, {10, true}, {30, false}, {80, true}});
  ASSERT_EQ(after.size(), 1u);
  EXPECT_EQ(after[0].start, Cycles{30});
}

TEST(LineReceiver, AMissingStopBitIsAFramingErrorAndNoStartBit) {
  const auto got =
      receive(kReceiverFormat, {{0, false}, {50, true}, {450, false}, {700, true}, {750, false}, {800, true}});
  ASSERT_EQ(got.size(), 2u);
  EXPECT_TRUE(got[0].framing_error);
  EXPECT_FALSE(got[0].is_break);
  EXPECT_EQ(got[0].data, 0xFF);
  EXPECT_EQ(got[1].start, Cycles{750});
  EXPECT_FALSE(got[1].framing_error);
}

TEST(LineReceiver, ABreakIsToldOnceHoweverLongItLasts) {
  const auto got = receive(kReceiverFormat, {{0, false}, {100'000, true}, {100'050, false}, {100'100, true}});
  ASSERT_EQ(got.size(), 2u);
  EXPECT_TRUE(got[0].is_break);
  EXPECT_FALSE(got[0].framing_error || got[0].parity_error);
  EXPECT_EQ(got[0].end, Cycles{475});
  EXPECT_EQ(got[1].data, 0xFF);
}

// Its parity bit is low, too: with odd parity that is the wrong one, but a break has none.
TEST(LineReceiver, ABreakHasNoParity) {
  const auto got = receive({.baud = 1'000'000, .parity = SerialParity::kOdd}, {{0, false}, {2'000, true}});
  ASSERT_EQ(got.size(), 1u);
  EXPECT_TRUE(got[0].is_break);
  EXPECT_FALSE(got[0].parity_error);
}

// Line sender and receiver share no code but the format: each is the other's oracle.
TEST(LineReceiver, UnderstandsEveryFormatWithinTwoPercentAndSeesEveryDefect) {
  constexpr std::uint64_t kSeed = 4;
  armature::test::SplitMix random{kSeed};
  for (const int bits : {5, 6, 7, 8}) {
    for (const auto parity :
         {SerialParity::kNone, SerialParity::kEven, SerialParity::kOdd, SerialParity::kMark, SerialParity::kSpace}) {
      for (const int half_bits : {2, 3, 4}) {
        const SerialFormat format{.baud = 115'200, .data_bits = bits, .parity = parity, .stop_half_bits = half_bits};
        LineSender sender{format};
        LineReceiver receiver{format};
        std::vector<LineItem> items;
        for (int i = 0; i < 60; ++i) {
          LineItem item{.data = static_cast<std::uint8_t>(random.next() & format.mask()),
                        .baud_error_ppm = static_cast<std::int32_t>(random.below(40'001)) - 20'000};
          item.wrong_parity = format.has_parity() && random.below(5) == 0;
          item.no_stop = random.below(5) == 0;
          if (item.no_stop && item.data == 0) item.data = 1;  // that would be a break
          items.push_back(item);
          sender.push(item, Cycles{0});
        }
        std::vector<ReceivedCharacter> got;
        bool level = true;
        for (std::int64_t cycle = 0; cycle < 600'000; ++cycle) {
          const Cycles now{cycle};
          sender.advance(now);
          if (std::exchange(level, sender.level()) != level) receiver.on_level(now, level);
          if (receiver.next_event() == now) receiver.advance(now);
          if (const auto character = receiver.pop()) got.push_back(*character);
          if (!sender.next_event() && !receiver.next_event()) break;
        }
        ASSERT_EQ(got.size(), items.size()) << "seed " << kSeed;
        for (std::size_t i = 0; i < items.size(); ++i) {
          SCOPED_TRACE(testing::Message() << bits << " bits, parity " << static_cast<int>(parity) << ", item " << i);
          ASSERT_EQ(got[i].data, items[i].data);
          ASSERT_EQ(got[i].parity_error, items[i].wrong_parity);
          ASSERT_EQ(got[i].framing_error, items[i].no_stop);
          ASSERT_FALSE(got[i].is_break);
        }
      }
    }
  }
}

}  // namespace
}  // namespace armature::cosim
