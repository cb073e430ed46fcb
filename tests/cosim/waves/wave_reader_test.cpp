// Reading of VCD files, those that other programs write included.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cosim/text/input_error.hpp"
#include "cosim/waves/wave_codes.hpp"
#include "cosim/waves/wave_reader.hpp"
#include "tests/cosim/support/temp_folder.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::cosim {
namespace {

using testing::ElementsAre;

constexpr const char* kHead =
    "$date today $end\n$version a $b c $end\n$timescale 1ns $end\n"
    "$scope module top $end\n$var wire 1 ! clk $end\n$scope module arm $end\n$var wire 6 \"# step [5:0] $end\n"
    "$upscope $end\n$var real 64 zzzz r $end\n$var wire 1 ! same $end\n$upscope $end\n$enddefinitions $end\n";

class WaveReaderTest : public ::testing::Test {
 protected:
  std::string error_of(const std::string& text) {
    try {
      // A file system may wait for the disk when a file is written again.
      WaveReader wave{folder_.write(std::to_string(++files_) + ".vcd", text)};
      while (wave.next_ps() && wave.next()) {
      }
    } catch (const InputError& error) {
      return error.problems().front().message;
    }
    return "no error";
  }

  test::TempFolder folder_;
  int files_ = 0;
};

TEST_F(WaveReaderTest, NamesSignalsWithTheirScopes) {
  const WaveReader wave{folder_.write("w.vcd", kHead)};
  std::vector<std::string> names;
  for (const WaveSignal& signal : wave.signals()) names.push_back(signal.name + signal.range);
  EXPECT_THAT(names, ElementsAre("top.clk", "top.arm.step[5:0]", "top.r", "top.same"));
  EXPECT_EQ(wave.signals()[0].value, wave.signals()[3].value);
  EXPECT_EQ(wave.values(), 3u);
  EXPECT_EQ(wave.signals()[1].bits, 6);
  EXPECT_EQ(wave.next_ps(), std::nullopt) << "it has no time";
}

TEST_F(WaveReaderTest, ReadsOneTimeAfterTheOther) {
  WaveReader wave{folder_.write("w.vcd", std::string{kHead} +
                                             "$dumpvars 1! b000101 \"#\nr1.5 zzzz $end\n#20\n0!\n$comment #7 1! $end\n"
                                             "#30 #30 1! b1 \"#\n#45\n")};
  ASSERT_EQ(wave.next_ps(), 20'000);
  ASSERT_TRUE(wave.next());
  EXPECT_EQ(wave.now_ps(), 20'000);
  EXPECT_THAT(wave.changed(), ElementsAre(0u));
  EXPECT_EQ(wave.value(0), "0");
  EXPECT_EQ(wave.value(1), "101");
  EXPECT_EQ(wave.value(2), "r1.5");
  ASSERT_TRUE(wave.next());
  EXPECT_EQ(wave.now_ps(), 30'000);
  EXPECT_THAT(wave.changed(), ElementsAre(0u, 1u));
  EXPECT_EQ(wave.value(1), "1");
  ASSERT_TRUE(wave.next());
  EXPECT_THAT(wave.changed(), ElementsAre());
  EXPECT_EQ(wave.next_ps(), std::nullopt);
}

TEST_F(WaveReaderTest, DigitsInFrontThatSayNothingMakeNoDifference) {
  const std::vector<std::pair<std::string, std::string>> cases{{"b0", "0"},         {"b000000", "0"}, {"b1", "1"},
                                                               {"b001100", "1100"}, {"bxx", "x"},     {"b0x1", "0x1"},
                                                               {"b00x1", "0x1"},    {"bzz10", "z10"}, {"b11", "11"}};
  for (const auto& [written, read] : cases) {
    WaveReader wave{folder_.write("w.vcd", std::string{kHead} + "#0\n" + written + " \"#\n")};
    ASSERT_TRUE(wave.next());
    EXPECT_EQ(wave.value(1), read) << written;
  }
}

TEST_F(WaveReaderTest, TheLastTimeOfAFileThatEndsEarlyIsNotUsed) {
  for (const char* end : {"#20\n1!\nb10", "#20\n1!\nb10 ", "#20\n1!\n#3", "#20\n1"}) {
    WaveReader wave{folder_.write("w.vcd", std::string{kHead} + "#10\n0!\n" + end)};
    ASSERT_TRUE(wave.next()) << end;
    EXPECT_FALSE(wave.next()) << end;
    EXPECT_EQ(wave.now_ps(), 10'000) << end;
    EXPECT_EQ(wave.next_ps(), std::nullopt) << end;
  }
}

TEST_F(WaveReaderTest, TimesHaveTheUnitOfTheFile) {
  for (const auto& [unit, ps] : std::vector<std::pair<std::string, std::int64_t>>{
           {"1 ps", 1}, {"10ps", 10}, {"100\nns", 100'000}, {"1us", 1'000'000}, {"1ms", 1'000'000'000}}) {
    WaveReader wave{
        folder_.write("w.vcd", "$timescale " + unit + " $end $var wire 1 a b $end $enddefinitions $end #3\n")};
    EXPECT_EQ(wave.next_ps(), 3 * ps) << unit;
  }
}

TEST_F(WaveReaderTest, WhatIsNoWaveformIsRefused) {
  const std::string head = kHead;
  EXPECT_EQ(error_of(""), "is no complete waveform: its declarations do not end");
  EXPECT_EQ(error_of("$scope module top $end\n"), "is no complete waveform: its declarations do not end");
  EXPECT_EQ(error_of("tick,state\n"), "expected a waveform in the form of VCD, found 'tick,state'");
  EXPECT_EQ(error_of("$timescale 1fs $end $enddefinitions $end "),
            "expected a $timescale from 1 ps to 100 ms, found '1fs'");
  EXPECT_EQ(error_of("$timescale 7 $end $enddefinitions $end "),
            "expected a $timescale from 1 ps to 100 ms, found '7'");
  EXPECT_EQ(error_of("$upscope $end\n"), "expected $scope before $upscope, found '$upscope'");
  EXPECT_EQ(error_of("$var wire -1 ! a $end\n"), "expected a number of bits, found '-1'");
  EXPECT_EQ(error_of(head + "#x\n"), "expected a time after #, found 'x'");
  EXPECT_EQ(error_of(head + "#9223372036854775807\n"), "expected a time after #, found '9223372036854775807'");
  EXPECT_EQ(error_of(head + "#10\n#5\n"), "expected times in ascending order, found '5'");
  EXPECT_EQ(error_of(head + "#10\n1?\n"), "expected the code of a signal, found '?'");
  EXPECT_EQ(error_of(head + "#10\n1 "), "expected the code of a signal, found ''");
  EXPECT_EQ(error_of(head + "#10\nhello "), "expected a time or the change of a value, found 'hello'");
  EXPECT_EQ(error_of(head + std::string(WaveInput::kLongestWord + 1, 'b')), "expected words of less than 128 KiB");
}

TEST_F(WaveReaderTest, WhateverTheBytesAreTheyAreReadOrRefused) {
  constexpr std::uint64_t kSeed = 2021;
  SCOPED_TRACE(kSeed);
  armature::test::SplitMix random{kSeed};
  const std::string good = std::string{kHead} + "#0\n1!\nb101 \"#\n#20\n0!\nb000001 \"#\n#40\nr2.5 zzzz\n1!\n#60\n";
  int refused = 0;
  for (int i = 0; i < 1500; ++i) {
    std::string text = good;
    for (std::uint32_t changes = 1 + random.below(3); changes > 0; --changes) {
      const std::size_t at = random.below(static_cast<std::uint32_t>(text.size()));
      if (random.below(3) == 0) {
        text.resize(at + 1);
      } else {
        text[at] = static_cast<char>(random.below(256));
      }
    }
    if (error_of(text) != "no error") ++refused;
  }
  EXPECT_GT(refused, 300);
  EXPECT_LT(refused, 1400);
}

TEST(WaveCodes, EveryCodeHasItsOwnNumber) {
  WaveCodes codes;
  std::vector<std::string> all{"", "!", "~", "!!", "~~", "!!!", "~~~", "!!!!", "\x80", "a b"};
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(codes.find(all[i]), WaveCodes::kNone) << i;
    EXPECT_EQ(codes.add(all[i]), i);
  }
  for (std::uint32_t i = 0; i < all.size(); ++i) EXPECT_EQ(codes.add(all[i]), i);
  EXPECT_EQ(codes.size(), all.size());
}

}  // namespace
}  // namespace armature::cosim
