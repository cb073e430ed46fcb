// Fixture of every test over AXI4-Lite: one verilated model, its bus driver, and the stall pattern as the parameter.
//
//   using MyBlockTest = AxiStallTest<Vmy_block>;
//   INSTANTIATE_AXI_STALLS(MyBlockTest);
//   TEST_P(MyBlockTest, ...)
#pragma once

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

  AxiLiteDriver<Dut> axi_{this->dut_, [this] { clock(); }, GetParam(), kAxiSeed};
};

#define INSTANTIATE_AXI_STALLS(Fixture)                                                           \
  INSTANTIATE_TEST_SUITE_P(Stalls, Fixture, ::testing::ValuesIn(::armature::test::kAllAxiStalls), \
                           [](const auto& suite) { return ::armature::test::name_of(suite.param); })

}  // namespace armature::test
