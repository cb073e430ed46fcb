// axi_uart16550: what every register holds, ignores and clears, and the modem lines.
#include "tests/rtl/uart_fixture.hpp"

namespace armature::test {
namespace {

using namespace uart;

class UartRegisters : public UartTest {
 protected:
  std::uint32_t fcr() {
    const std::uint32_t lcr = read(kLcr);
    write(kLcr, lcr | kDlab);
    const std::uint32_t value = read(kFcr);
    write(kLcr, lcr);
    return value;
  }
};
INSTANTIATE_AXI_STALLS(UartRegisters);

TEST_P(UartRegisters, ResetStateIsIdle) {
  EXPECT_EQ(read(kRbr), 0u);
  EXPECT_EQ(read(kIer), 0u);
  EXPECT_EQ(read(kIir), 0x01u);
  EXPECT_EQ(read(kLcr), 0u);
  EXPECT_EQ(read(kMcr), 0u);
  EXPECT_EQ(read(kLsr), kThre | kTemt);
  EXPECT_EQ(read(kMsr), 0u);
  EXPECT_EQ(read(kScr), 0u);
  write(kLcr, kDlab);
  EXPECT_EQ(read(kDll), 0u);
  EXPECT_EQ(read(kDlm), 0u);
  EXPECT_EQ(read(kFcr), 0u);
  EXPECT_TRUE(dut_.txd_o && dut_.rts_no && dut_.dtr_no && dut_.out1_no && dut_.out2_no);
  EXPECT_FALSE(dut_.irq_o);
}

TEST_P(UartRegisters, ResetTakesTheModemLinesAsTheyAre) {
  dut_.rst_ni = 0;
  dut_.cts_ni = dut_.dcd_ni = 0;
  axi_.step(kResetCycles);
  dut_.rst_ni = 1;
  axi_.step(8);
  EXPECT_EQ(read(kMsr), 0x90u) << "no change was seen";
}

TEST_P(UartRegisters, WordsOfTheMapWithoutARegisterReadZeroAndIgnoreWrites) {
  for (const std::uint32_t address : {0x0u, 0x4u, 0x14u, 0x1Cu, 0x400u, 0xFFCu, 0x1020u, 0x1100u, 0x1FFCu}) {
    EXPECT_EQ(axi_.write(address, 0xFFFF'FFFFu), AxiResp::kOkay) << address;
    EXPECT_EQ(axi_.read(address), (AxiReadResult{AxiResp::kOkay, 0})) << address;
  }
  EXPECT_EQ(read(kScr), 0u);
  EXPECT_EQ(read(kIer), 0u);
  EXPECT_EQ(read(kLsr), kThre | kTemt) << "nothing was sent";
}

TEST_P(UartRegisters, OffsetsBeyondTheMapAnswerSlvErr) {
  for (const std::uint32_t address : {0x2000u, 0x3014u, 0xFFFCu}) {
    EXPECT_EQ(axi_.write(address, 0), AxiResp::kSlvErr) << address;
    EXPECT_EQ(axi_.read(address), (AxiReadResult{AxiResp::kSlvErr, 0xBADA'CCE5u})) << address;
  }
}

TEST_P(UartRegisters, WritesToTheStatusRegistersAreIgnored) {
  dut_.cts_ni = 0;
  axi_.step(8);
  for (const std::uint32_t data : {0u, 0xFFFF'FFFFu}) {
    EXPECT_EQ(axi_.write(kLsr, data), AxiResp::kOkay);
    EXPECT_EQ(axi_.write(kMsr, data), AxiResp::kOkay);
  }
  EXPECT_EQ(read(kLsr), kThre | kTemt);
  EXPECT_EQ(read(kMsr), 0x11u) << "the change of CTS is still there";
  EXPECT_EQ(read(kMsr), 0x10u);
}

TEST_P(UartRegisters, OnlyBitsWithAFunctionAreKept) {
  write(kIer, 0xFFFF'FFFFu);
  EXPECT_EQ(read(kIer), 0x0Fu);
  write(kMcr, 0xFFFF'FFFFu);
  EXPECT_EQ(read(kMcr), 0x1Fu);
  write(kScr, 0xFFFF'FF5Au);
  EXPECT_EQ(read(kScr), 0x5Au);
  write(kLcr, 0xFFFF'FFFFu);
  EXPECT_EQ(read(kLcr), 0xFFu);
  write(kDll, 0xFFFF'FFA5u);
  write(kDlm, 0xFFFF'FFC3u);
  EXPECT_EQ(read(kDll), 0xA5u);
  EXPECT_EQ(read(kDlm), 0xC3u);
}

TEST_P(UartRegisters, AWriteCountsOnlyWithByteZero) {
  configure(1);
  write(kFcr, 0x81);
  for (const std::uint32_t reg : {kThr, kIer, kFcr, kLcr, kMcr, kScr}) {
    EXPECT_EQ(axi_.write(reg, 0x5A5A'5A5Au, 0xE), AxiResp::kOkay);
    EXPECT_EQ(axi_.write(reg, 0x5A5A'5A5Au, 0x0), AxiResp::kOkay);
  }
  axi_.step(400);
  EXPECT_TRUE(receiver_.characters.empty());
  EXPECT_EQ(read(kIer), 0u);
  EXPECT_EQ(read(kLcr), UartFormat{}.lcr());
  EXPECT_EQ(read(kMcr), 0u);
  EXPECT_EQ(read(kScr), 0u);
  EXPECT_EQ(fcr(), 0x81u);
  for (const std::uint32_t reg : {kIer, kMcr, kScr}) {
    EXPECT_EQ(axi_.write(reg, 0xFFFF'FF05u, 0x1), AxiResp::kOkay);
    EXPECT_EQ(read(reg), 0x05u);
  }
  EXPECT_EQ(axi_.write(kThr, 0x77, 0x1), AxiResp::kOkay);
  finish_transmitting();
  EXPECT_EQ(receiver_.data(), std::vector<unsigned>{0x77});
}

TEST_P(UartRegisters, DlabSwapsTheDivisorInAndTouchesNothingElse) {
  configure(1);
  write(kFcr, kFifoOn);
  write(kIer, kIerModem);
  receive(0x41);
  receive(0x42);
  write(kLcr, kDlab | format_.lcr());
  EXPECT_EQ(read(kDll), 1u);
  EXPECT_EQ(read(kDll), 1u) << "reading DLL takes no character";
  write(kDll, 2);
  write(kDlm, 0xFF);
  write(kDlm, 0);
  EXPECT_EQ(read(kDll), 2u);
  EXPECT_EQ(read(kDlm), 0u);
  EXPECT_EQ(read(kLsr), kDr | kThre | kTemt) << "writing DLL sends nothing";
  write(kLcr, format_.lcr());
  EXPECT_EQ(read(kIer), kIerModem);
  EXPECT_EQ(read(kRbr), 0x41u);
  EXPECT_EQ(read(kRbr), 0x42u);
  EXPECT_EQ(read(kLsr), kThre | kTemt);
}

TEST_P(UartRegisters, FcrReadsBackWithDlab) {
  for (const std::uint32_t value : {0x01u, 0x81u, 0xCFu, 0x41u, 0x09u, 0xC7u, 0xF1u, 0xBFu}) {
    write(kFcr, value);
    EXPECT_EQ(fcr(), value & 0xC9u);
    EXPECT_EQ(read(kIir), 0xC1u);
    write(kMcr, kLoop);
    EXPECT_EQ(fcr(), value & 0xC9u) << "bit 4 does not follow loopback";
    write(kMcr, 0);
  }
  write(kFcr, 0x40);  // without bit 0 the other bits are not written
  EXPECT_EQ(fcr(), 0x88u);
  EXPECT_EQ(read(kIir), 0x01u);
}

TEST_P(UartRegisters, FcrIsWrittenWhateverDlabSays) {
  write(kLcr, kDlab);
  write(kFcr, 0xC1);
  EXPECT_EQ(read(kFcr), 0xC1u);
}

TEST_P(UartRegisters, OnlyTheEnableBitAndTheFlushBitsFlush) {
  configure(1);
  write(kFcr, 0x01);
  receive(0x11);
  for (const std::uint32_t value : {0x01u, 0x81u, 0xC9u, 0x05u, 0x41u}) {
    write(kFcr, value);
    EXPECT_EQ(read(kLsr) & kDr, kDr) << "FCR " << value;
  }
  write(kFcr, 0x03);
  EXPECT_EQ(read(kLsr) & kDr, 0u);
  receive(0x12);
  write(kFcr, 0x00);
  EXPECT_EQ(read(kLsr) & kDr, 0u) << "switching the FIFOs off empties them";
  receive(0x13);
  write(kFcr, 0x06);
  EXPECT_EQ(read(kLsr) & kDr, kDr) << "the flush bits count only with bit 0";
  write(kFcr, 0x01);
  EXPECT_EQ(read(kLsr) & kDr, 0u) << "switching the FIFOs on empties them";
  EXPECT_EQ(read(kRbr), 0u);
}

TEST_P(UartRegisters, ModemOutputsAreLowActive) {
  for (std::uint32_t value = 0; value < 16; ++value) {
    write(kMcr, value);
    EXPECT_EQ(dut_.dtr_no, (value & 1) == 0);
    EXPECT_EQ(dut_.rts_no, (value & 2) == 0);
    EXPECT_EQ(dut_.out1_no, (value & 4) == 0);
    EXPECT_EQ(dut_.out2_no, (value & 8) == 0);
    write(kMcr, value | kLoop);
    EXPECT_TRUE(dut_.dtr_no && dut_.rts_no && dut_.out1_no && dut_.out2_no) << "idle in loopback";
  }
}

// In loopback OUT2, OUT1, DTR, RTS are DCD, RI, DSR, CTS; the pins are ignored.
TEST_P(UartRegisters, LoopbackConnectsTheModemLines) {
  static constexpr std::uint32_t kLine[] = {0x20, 0x10, 0x40, 0x80};  // of MCR 0 to 3
  write(kMcr, kLoop);
  EXPECT_EQ(read(kMsr), 0u);
  dut_.cts_ni = dut_.dsr_ni = dut_.dcd_ni = dut_.ri_ni = 0;
  axi_.step(10);
  EXPECT_EQ(read(kMsr), 0u);
  for (std::uint32_t value = 0; value < 16; ++value) {
    std::uint32_t expected = 0;
    for (unsigned i = 0; i < 4; ++i) expected |= (value >> i & 1u) != 0 ? kLine[i] : 0;
    write(kMcr, kLoop | value);
    EXPECT_EQ(read(kMsr) & 0xF0u, expected);
  }
}

TEST_P(UartRegisters, ModemInputsReportTheirChangesOnce) {
  const auto set = [this](unsigned line, bool active) {
    (line == 0 ? dut_.cts_ni : line == 1 ? dut_.dsr_ni : line == 2 ? dut_.ri_ni : dut_.dcd_ni) = !active;
    axi_.step(6);
  };
  write(kIer, kIerModem);
  for (unsigned line = 0; line < 4; ++line) {
    const std::uint32_t change = 1u << line, level = 0x10u << line;
    set(line, true);
    EXPECT_EQ(dut_.irq_o, line != 2) << "a ring counts when it ends";
    EXPECT_EQ(read(kIir), line != 2 ? 0x00u : 0x01u);
    EXPECT_EQ(read(kMsr), line != 2 ? level | change : level);
    EXPECT_EQ(read(kMsr), level);
    EXPECT_FALSE(dut_.irq_o);
    set(line, false);
    EXPECT_TRUE(dut_.irq_o);
    EXPECT_EQ(read(kMsr), change);
    EXPECT_EQ(read(kIir), 0x01u);
  }
  // Two changes between two reads are one report.
  set(0, true);
  set(0, false);
  EXPECT_EQ(read(kMsr), 0x01u);
}

// A change at any clock around a read shows in that read or in the next one, never in both or in neither.
TEST_P(UartRegisters, AChangeThatMeetsTheReadIsNotLost) {
  bool active = false, first = false, second = false;
  for (int offset = 0; offset < 12; ++offset) {
    axi_.step(20);
    active = !active;
    dut_.cts_ni = !active;
    axi_.step(offset);
    const std::uint32_t early = read(kMsr) & 1u;
    axi_.step(8);
    const std::uint32_t late = read(kMsr) & 1u;
    EXPECT_EQ(early + late, 1u) << "offset " << offset;
    first |= early != 0;
    second |= late != 0;
  }
  EXPECT_TRUE(first);
  EXPECT_TRUE(second || GetParam() != AxiStall::kNone) << "the sweep did not cross the event";
}

TEST_P(UartRegisters, DivisorZeroNeitherSendsNorReceives) {
  configure(0);
  write(kFcr, kFifoOn);
  write(kThr, 0x5A);
  sender_.bit_clocks = 16;
  sender_.send(0x33, format_);
  while (!sender_.idle()) axi_.step();
  axi_.step(500);
  EXPECT_EQ(read(kLsr), 0u) << "the character waits";
  EXPECT_EQ(receiver_.segments.size(), 1u);
  configure(3);
  finish_transmitting();
  EXPECT_EQ(receiver_.data(), std::vector<unsigned>{0x5A});
}

TEST_P(UartRegisters, TheDivisorIsZeroWhicheverByteIsWrittenLast) {
  for (const bool high_last : {false, true}) {
    write(kFcr, kFifoOn | kFlushTx);  // what the last turn has left
    configure(1);
    write(kLcr, kDlab | format_.lcr());
    if (high_last) {
      write(kDlm, 1);
      write(kDll, 0);
      write(kDlm, 0);
    } else {
      write(kDlm, 0);
      write(kDll, 0);
    }
    write(kLcr, format_.lcr());
    write(kThr, 0x5A);
    axi_.step(500);
    EXPECT_EQ(read(kLsr), 0u) << "high byte last: " << high_last;
  }
  EXPECT_TRUE(receiver_.characters.empty());
}

}  // namespace
}  // namespace armature::test
