// pulse_width through its AXI port under every stall pattern: what is stored and what is refused.
#include <array>

#include "Vpulse_width.h"
#include "controller/regs/pulse_width_regs.hpp"
#include "tests/support/axi_stall_test.hpp"

namespace armature::test {
namespace {

namespace reg = regs::pulse_width;

class PulseWidthRegisters : public AxiStallTest<Vpulse_width> {
 protected:
  void SetUp() override {
    dut_.estop_ni = 1;
    dut_.trigger_i = 0;
    dut_.home_i = dut_.limit_pos_i = dut_.limit_neg_i = dut_.drive_alarm_i = dut_.in_position_i = 0;
    AxiStallTest::SetUp();
  }
};
INSTANTIATE_AXI_STALLS(PulseWidthRegisters);

TEST_P(PulseWidthRegisters, IdentifiesItselfAndResetsToZero) {
  EXPECT_EQ(read(0x00), 0x5057'0106U);
  for (const std::uint32_t offset : {0x04U, 0x08U, 0x0CU, 0x10U, 0x30U, 0x34U, 0x40U, 0x54U, 0x60U, 0x74U, 0xA0U}) {
    EXPECT_EQ(read(offset), 0U) << std::hex << offset;
  }
}

TEST_P(PulseWidthRegisters, EveryWritableBitIsItsOwn) {
  const auto pattern = [](std::uint32_t offset) { return 0x9E37'79B9U * (offset + 1); };
  for (std::uint32_t offset = 0x40; offset <= 0x54; offset += 4) write(offset, pattern(offset));
  write(0x04, 0xFFFF'FFEA);
  EXPECT_EQ(read(0x04), 0x2AU);
  for (std::uint32_t offset = 0x40; offset <= 0x54; offset += 4) EXPECT_EQ(read(offset), pattern(offset));
  EXPECT_EQ(read(0x08), 0x3F00U);
  for (std::uint32_t offset = 0x40; offset <= 0x54; offset += 4) write(offset, 0, 0x4);
  for (std::uint32_t offset = 0x40; offset <= 0x54; offset += 4) EXPECT_EQ(read(offset), pattern(offset) & 0xFF00'FFFF);
}

TEST_P(PulseWidthRegisters, WriteWithoutAByteArmsNothing) {
  write(reg::kWidthOffset, 100, 0x0);
  EXPECT_EQ(read(reg::kStatusOffset), 0U);
}

TEST_P(PulseWidthRegisters, ReadOnlyAndUnmappedOffsetsRefuse) {
  for (const std::uint32_t offset : {0x00U, 0x08U, 0x2CU, 0x30U, 0x34U, 0x60U, 0x74U, 0xA0U, 0x14U, 0x58U, 0x1004U}) {
    EXPECT_EQ(axi_.write(offset, 0xFFFF'FFFFU), AxiResp::kSlvErr) << std::hex << offset;
  }
  for (const std::uint32_t offset : {0x14U, 0x28U, 0x58U, 0x78U, 0xA4U, 0x1000U}) {
    EXPECT_EQ(axi_.read(offset), (AxiReadResult{AxiResp::kSlvErr, 0xBADA'CCE5})) << std::hex << offset;
  }
}

}  // namespace
}  // namespace armature::test
