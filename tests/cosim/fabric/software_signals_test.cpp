#include "cosim/fabric/software_signals.hpp"

#include <gtest/gtest.h>

#include <string>

#include "cosim/fabric/register_table.hpp"

namespace armature::cosim {
namespace {

const SoftwareSignalRow& row(SoftwareSignal signal) {
  return kSoftwareSignals[static_cast<std::size_t>(signal)];
}

std::string text_of(const SoftwareSignals& signals, SoftwareSignal signal) {
  std::string text;
  for (int bit = row(signal).bits - 8; bit >= 0; bit -= 8) {
    const std::uint32_t word = signals.words(row(signal))[bit / 32];
    text += static_cast<char>((word >> (bit % 32)) & 0xFFu);
  }
  return text;
}

TEST(SoftwareSignals, ATextEndsInTheLowestBits) {
  SoftwareSignals signals;
  signals.set(SoftwareSignal::kCore0, "computing");
  EXPECT_EQ(text_of(signals, SoftwareSignal::kCore0), "computing");
  signals.set(SoftwareSignal::kCore0, "bus");
  EXPECT_EQ(text_of(signals, SoftwareSignal::kCore0), (std::string(6, '\0') + "bus"));
  EXPECT_EQ(signals.words(row(SoftwareSignal::kCore0))[0], 0x0062'7573u);
}

TEST(SoftwareSignals, ATextThatIsTooLongLosesItsEndAndChangesNoNeighbour) {
  SoftwareSignals signals;
  signals.set(SoftwareSignal::kCore0, "computing");
  signals.set(SoftwareSignal::kBusBusy, 1);
  signals.set(SoftwareSignal::kCore1, "waiting for ever");
  EXPECT_EQ(text_of(signals, SoftwareSignal::kCore1), "waiting f");
  EXPECT_EQ(text_of(signals, SoftwareSignal::kCore0), "computing");
  EXPECT_EQ(*signals.words(row(SoftwareSignal::kBusBusy)), 1u);
}

TEST(RegisterTable, NamesTheRegistersOfTheVariant) {
  EXPECT_EQ(register_name(Variant::kCounts, 0x43C1'0000), "pulse_train.id");
  EXPECT_EQ(register_name(Variant::kPaper, 0x43C1'0000), "pulse_width.id");
  EXPECT_EQ(register_name(Variant::kCounts, 0x43C1'0054), "pulse_train.count[5]");
  EXPECT_EQ(register_name(Variant::kCounts, 0x43C2'0020), "encoder.position[0]");
  EXPECT_EQ(register_name(Variant::kPaper, 0x43C3'0004), "encoder_switch.select");
  EXPECT_EQ(register_name(Variant::kCounts, 0x43C3'0004), "") << "only the paper's variant has the switch";
  EXPECT_EQ(register_name(Variant::kCounts, 0x43C1'0058), "") << "behind the array";
}

}  // namespace
}  // namespace armature::cosim
