// Fixture of every test over AXI4-Lite: one verilated model, its bus driver, and the stall pattern as the parameter.
//
//   using MyBlockTest = AxiStallTest<Vmy_block>;
//   INSTANTIATE_AXI_STALLS(MyBlockTest);
//   TEST_P(MyBlockTest, ...)
#pragma once

#include <cstdint>
#include <ios>

#include "tests/support/axi_lite_driver.hpp"
#include "tests/support/verilated_test.hpp"

namespace armature::test {

inline constexpr std::uint64_t kAxiSeed = 2012;

template <class Dut>
class AxiStallTest : public VerilatedTest<Dut>, public ::testing::WithParamInterface<AxiStall> {
 protected:
  void SetUp() override {
    this->dut_.rst_ni = 0;
    axi_.step(kResetCycles);
    this->dut_.rst_ni = 1;
    this->cycle_ = 0;
  }

  // One clock of the model, without the bus driver. Fixtures add what surrounds their block.
  virtual void clock() { this->tick(); }

  // Accesses that are answered OKAY.
  void write(std::uint32_t addr, std::uint32_t value, unsigned strobe = 0xF) {
    EXPECT_EQ(axi_.write(addr, value, strobe), AxiResp::kOkay) << std::hex << addr;
  }
  std::uint32_t read(std::uint32_t addr) {
    const AxiReadResult result = axi_.read(addr);
    EXPECT_EQ(result.resp, AxiResp::kOkay) << std::hex << addr;
    return result.data;
  }

  AxiLiteDriver<Dut> axi_{this->dut_, [this] { clock(); }, GetParam(), kAxiSeed};
};

#define INSTANTIATE_AXI_STALLS(Fixture)                                                           \
  INSTANTIATE_TEST_SUITE_P(Stalls, Fixture, ::testing::ValuesIn(::armature::test::kAllAxiStalls), \
                           [](const auto& suite) { return ::armature::test::name_of(suite.param); })

}  // namespace armature::test
