// policy_mlp through its AXI port: every register sets or shows the thing it is named after.
#include <cstddef>
#include <cstdint>
#include <vector>

#include "Vpolicy_mlp.h"
#include "controller/regs/policy_mlp_regs.hpp"
#include "cosim/model/policy_mlp/network_run.hpp"
#include "tests/support/axi_stall_test.hpp"
#include "tests/support/mlp_images.hpp"

namespace armature::test {
namespace {

namespace reg = regs::policy_mlp;
namespace mlp = cosim::model::mlp;

class PolicyMlpRegisters : public AxiStallTest<Vpolicy_mlp> {
 protected:
  // The edges that the block need not have it gets, or not, at random.
  void clock() override {
    dut_.eval();  // active_o looks at inputs
    if (dut_.active_o || !dut_.rst_ni || random_.below(2) == 0) tick();
  }
  void wait_for_the_end() {
    for (int i = 0; i < 400; ++i) clock();
  }

  // A network with its inputs, ready to start. Returns its outputs without the bound.
  mlp::Outcome write_network() {
    RandomNetworks networks{3721};
    const TestImage image = image_of(networks.of({32, 12, 8}), 8);
    mlp::Memory memory{};
    write(reg::kAddressOffset, 0);
    for (std::size_t i = 0; i < image.size(); ++i) {
      write(reg::kDataOffset, image[i]);
      memory[i] = image[i];
    }
    EXPECT_EQ(read(reg::kAddressOffset), image.size());
    const std::vector<std::int8_t> inputs = networks.inputs(32);
    mlp::Inputs bytes{};
    for (std::uint32_t i = 0; i < reg::kInputCount; ++i) {
      std::uint32_t word = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        bytes[4 * i + k] = inputs[4 * i + k];
        word |= std::uint32_t{static_cast<std::uint8_t>(bytes[4 * i + k])} << (8 * k);
      }
      write(reg::kInputOffset + 4 * i, word);
      EXPECT_EQ(read(reg::kInputOffset + 4 * i), word);
    }
    const mlp::Outcome outcome = mlp::evaluate(memory, 8, bytes);
    write(reg::kCrcOffset, outcome.crc);
    EXPECT_EQ(read(reg::kCrcOffset), outcome.crc);
    return outcome;
  }
  void set_bound(std::uint32_t bound) {
    write(reg::kBoundOffset, bound);
    EXPECT_EQ(read(reg::kBoundOffset), bound & 0x7Fu);
  }
  void start(bool irq = false) { write(reg::kCtrlOffset, reg::kCtrlStartMask | (irq ? reg::kCtrlIrqMask : 0)); }
  int output(std::uint32_t i) {
    return static_cast<std::int8_t>(read(reg::kOutputOffset + i / 4 * 4) >> (8 * (i % 4)));
  }

 private:
  SplitMix random_{kPowerUpSeed};
};
INSTANTIATE_AXI_STALLS(PolicyMlpRegisters);

TEST_P(PolicyMlpRegisters, IdentifiesItself) {
  EXPECT_EQ(read(reg::kIdOffset), 0x504D'0108u);
}

TEST_P(PolicyMlpRegisters, IsIdleAfterResetWithABoundOf0) {
  for (const std::uint32_t offset :
       {reg::kCtrlOffset, reg::kStatusOffset, reg::kEventOffset, reg::kBoundOffset, reg::kCrcOffset,
        reg::kCrcReadOffset, reg::kAddressOffset, reg::kDataOffset, reg::kOutputOffset, reg::kOutputOffset + 4}) {
    EXPECT_EQ(read(offset), 0u) << offset;
  }
  EXPECT_FALSE(dut_.irq_o);
}

TEST_P(PolicyMlpRegisters, EvaluatesANetworkWithinTheBound) {
  const mlp::Outcome expected = write_network();
  set_bound(127);
  start();
  EXPECT_EQ(read(reg::kStatusOffset), reg::kStatusBusyMask);
  EXPECT_EQ(read(reg::kCrcReadOffset), 0u);
  wait_for_the_end();
  EXPECT_EQ(read(reg::kStatusOffset), reg::kStatusDoneMask);
  EXPECT_EQ(read(reg::kCyclesOffset), static_cast<std::uint32_t>(expected.clocks));
  EXPECT_EQ(read(reg::kCrcReadOffset), expected.crc);
  for (std::uint32_t i = 0; i < 8; ++i) EXPECT_EQ(output(i), std::max<int>(expected.outputs[i], -127)) << i;
  set_bound(0x80 + 10);
  for (std::uint32_t i = 0; i < 8; ++i) EXPECT_EQ(output(i), std::clamp<int>(expected.outputs[i], -10, 10)) << i;
  set_bound(0);
  EXPECT_EQ(read(reg::kOutputOffset), 0u);
}

TEST_P(PolicyMlpRegisters, ACorruptImageHasNoOutput) {
  const mlp::Outcome expected = write_network();
  set_bound(127);
  write(reg::kCrcOffset, expected.crc ^ 0x100u);
  start();
  wait_for_the_end();
  EXPECT_EQ(read(reg::kStatusOffset), reg::kStatusCorruptMask);
  EXPECT_EQ(read(reg::kEventOffset), reg::kEventEndedMask);
  EXPECT_EQ(read(reg::kOutputOffset), 0u);
  EXPECT_EQ(read(reg::kOutputOffset + 4), 0u);
}

TEST_P(PolicyMlpRegisters, InterruptIsTheEventIfItIsEnabled) {
  write_network();
  start(true);
  wait_for_the_end();
  EXPECT_EQ(read(reg::kEventOffset), reg::kEventEndedMask);
  EXPECT_TRUE(dut_.irq_o);
  write(reg::kCtrlOffset, 0);
  EXPECT_FALSE(dut_.irq_o);
  write(reg::kCtrlOffset, reg::kCtrlIrqMask);
  EXPECT_TRUE(dut_.irq_o);
  write(reg::kEventOffset, reg::kEventEndedMask);
  EXPECT_FALSE(dut_.irq_o);
  EXPECT_EQ(read(reg::kStatusOffset), reg::kStatusDoneMask);
}

TEST_P(PolicyMlpRegisters, AStartAndDataAreRefusedWhileBusy) {
  const mlp::Outcome expected = write_network();
  for (const bool data : {false, true}) {
    write(reg::kAddressOffset, 0);
    start();
    if (data) {
      write(reg::kDataOffset, 1);
    } else {
      start();
    }
    EXPECT_EQ(read(reg::kStatusOffset), reg::kStatusBusyMask | reg::kStatusRefusedMask);
    EXPECT_EQ(read(reg::kAddressOffset), 0u);
    wait_for_the_end();
    EXPECT_EQ(read(reg::kStatusOffset), reg::kStatusDoneMask | reg::kStatusRefusedMask);
    EXPECT_EQ(read(reg::kCrcReadOffset), expected.crc);
  }
}

}  // namespace
}  // namespace armature::test
