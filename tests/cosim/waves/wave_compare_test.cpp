// The first difference of two waveforms, with waveforms of a few lines.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "cosim/waves/wave_compare.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string head(const std::string& declarations) {
  return "$timescale 1ns $end\n$scope module top $end\n" + declarations + "$upscope $end\n$enddefinitions $end\n";
}

const std::string kPins = "$var wire 1 ! step_o $end\n$var wire 8 \" count [7:0] $end\n";

class WaveCompare : public ::testing::Test {
 protected:
  WaveComparison compare(const std::string& a, const std::string& b) {
    return compare_waves(folder_.write("a.vcd", a), folder_.write("b.vcd", b));
  }
  std::string report(WaveComparison comparison) {
    comparison.a = "a.vcd";
    comparison.b = "b.vcd";
    return comparison.report();
  }

  test::TempFolder folder_;
};

TEST_F(WaveCompare, EqualValuesAreEqualWhenTheyAreWritten) {
  // b writes values that have not changed, at times of its own.
  const WaveComparison found = compare(head(kPins) + "#20\n0!\nb00000101 \"\n#60\n1!\n#80\n",
                                       head(kPins) + "#20\n0!\nb101 \"\n#30\n#40\n0!\n#60\n1!\nb101 \"\n#80\n");
  EXPECT_TRUE(found.equal());
  EXPECT_EQ(report(found),
            "PASS a.vcd and b.vcd are equal: 2 signals from cycle 1 (0.00000002 s) to cycle 4 (0.00000008 s)\n");
}

TEST_F(WaveCompare, NamesEverySignalThatDiffersFirst) {
  const WaveComparison found = compare(head(kPins) + "#20\n0!\nb0 \"\n#70\n1!\nb11111 \"\n#80\n0!\n",
                                       head(kPins) + "#20\n0!\nb0 \"\n#70\nb11110 \"\n#80\n0!\nb0 \"\n");
  EXPECT_FALSE(found.equal());
  EXPECT_EQ(report(found),
            "FAIL a.vcd and b.vcd differ first in cycle 3 (0.00000006 s)\n"
            "  top.step_o: a.vcd: 1, b.vcd: 0\n"
            "  top.count[7:0]: a.vcd: 0x1F, b.vcd: 0x1E\n"
            "  2 signals were compared from cycle 1 (0.00000002 s) on\n");
}

TEST_F(WaveCompare, AValueThatIsBackAtTheNextTimeIsFound) {
  const std::string a = head(kPins) + "#20\n0!\nb0 \"\n#40\n#60\n";
  EXPECT_EQ(compare(a, head(kPins) + "#20\n0!\nb0 \"\n#40\n1!\n#50\n0!\n#60\n").first.value().at_ps, 40'000);
  EXPECT_EQ(compare(a, head(kPins) + "#20\n0!\nb0 \"\n#45\n1!\n#50\n0!\n#60\n").first.value().at_ps, 45'000);
  EXPECT_EQ(compare(a, head(kPins) + "#20\n0!\nb0 \"\n#60\n1!\n").first.value().at_ps, 60'000) << "the last time";
}

TEST_F(WaveCompare, OnlyThePartThatBothHaveIsCompared) {
  const std::string whole = head(kPins) + "#20\n0!\nb0 \"\n#40\n1!\n#60\n0!\n#80\nb1 \"\n#100\n1!\n";
  const std::string part = head(kPins) + "#40\n1!\nb0 \"\n#60\n0!\n#80\nb1 \"\n";
  for (const WaveComparison& found : {compare(whole, part), compare(part, whole)}) {
    EXPECT_TRUE(found.equal());
    EXPECT_EQ(found.from_ps, 40'000);
    EXPECT_EQ(found.to_ps, 80'000);
  }
  // The value at the first common time is the one before it.
  const std::string other = head(kPins) + "#50\n0!\nb0 \"\n#60\n0!\n";
  EXPECT_EQ(compare(whole, other).first.value().at_ps, 50'000);
}

TEST_F(WaveCompare, WithoutACommonTimeOrSignalNothingIsEqual) {
  const std::string early = head(kPins) + "#20\n0!\nb0 \"\n#40\n1!\n";
  const std::string late = head(kPins) + "#60\n1!\nb0 \"\n#80\n";
  EXPECT_EQ(report(compare(early, late)),
            "FAIL a.vcd and b.vcd have no time in common\n"
            "  a.vcd ends in cycle 2 (0.00000004 s), b.vcd begins in cycle 3 (0.00000006 s)\n");
  EXPECT_EQ(report(compare(late, early)),
            "FAIL a.vcd and b.vcd have no time in common\n"
            "  b.vcd ends in cycle 2 (0.00000004 s), a.vcd begins in cycle 3 (0.00000006 s)\n");
  const WaveComparison found = compare(early, head("$var wire 1 ! x $end\n") + "#20\n0!\n");
  EXPECT_FALSE(found.equal());
  EXPECT_EQ(report(found), "FAIL a.vcd and b.vcd have no signal in common\n");
  EXPECT_EQ(report(compare(early, head(kPins))), "FAIL a.vcd and b.vcd have no time in common\n  b.vcd has none\n");
}

TEST_F(WaveCompare, SignalsOfOneFileAreListed) {
  const std::string more = "$var wire 1 # clk $end\n";
  const std::string other = "$var wire 4 \" count [3:0] $end\n$var wire 1 % step_o $end\n";
  const WaveComparison found = compare(head(kPins + more) + "#0\n0!\nb0 \"\n1#\n", head(other) + "#0\n0%\nb1 \"\n");
  EXPECT_TRUE(found.equal());
  EXPECT_THAT(found.only_a, ElementsAre("top.count[7:0]", "top.clk"));
  EXPECT_THAT(report(found), HasSubstr("\n  2 signals only in a.vcd: top.count[7:0], top.clk\n"
                                       "  1 signal only in b.vcd: top.count[3:0]\n"));
}

// The file that begins later does not know the latest access yet.
TEST_F(WaveCompare, TheLatestAccessIsComparedFromTheFirstOneInBothFiles) {
  const std::string software =
      "$scope module software $end\n$var wire 32 ! tick [31:0] $end\n$var wire 32 \" bus_address [31:0] $end\n"
      "$var wire 72 # core0 [71:0] $end\n$upscope $end\n";
  const std::string early = head(software) + "#0\nb111 !\nb1000 \"\nb0 #\n#20\n#40\nb1100 \"\n#60\n";
  const auto late = [&](const std::string& rest) { return head(software) + "#20\nb111 !\nb0 \"\nb0 #\n" + rest; };
  EXPECT_TRUE(compare(early, late("#40\nb1100 \"\n#60\n")).equal());
  EXPECT_TRUE(compare(late("#40\nb1100 \"\n#60\n"), early).equal());
  EXPECT_EQ(compare(early, late("#40\nb1101 \"\n#60\n")).first.value().at_ps, 40'000);
  EXPECT_EQ(compare(early, late("#30\nb1 \"\n#60\n")).first.value().at_ps, 30'000);
  EXPECT_EQ(compare(early, late("#40\nb1100 \"\n#60\nb1 \"\n")).first.value().at_ps, 60'000);
  const WaveComparison core = compare(early, late("#40\nb1100 \"\nb011000100111010101110011 #\n#60\n"));
  EXPECT_THAT(report(core), HasSubstr("differ first in cycle 2 (0.00000004 s), tick 7\n"
                                      "  top.software.core0[71:0]: a.vcd: '', b.vcd: 'bus'\n"));
  // Of files that begin together every value counts.
  EXPECT_EQ(compare(head(software) + "#20\nb1 \"\n", head(software) + "#20\nb0 \"\n").first.value().at_ps, 20'000);
}

TEST_F(WaveCompare, TheTicksOfBothFilesAreNamed) {
  const std::string software = "$scope module software $end\n$var wire 32 ! tick [31:0] $end\n$upscope $end\n";
  const std::string minus_one(32, '1');
  EXPECT_THAT(report(compare(head(software) + "#0\nb" + minus_one + " !\n", head(software) + "#0\nb0 !\n")),
              HasSubstr(" s), ticks -1 and 0\n  top.software.tick[31:0]: a.vcd: 0xFFFFFFFF, b.vcd: 0x0\n"));
}

}  // namespace
}  // namespace armature::cosim
