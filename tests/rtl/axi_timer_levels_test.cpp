// Active-low capture pins and GenerateOut, by parameter.
#include "Vtimer_core_low.h"
#include "tests/rtl/axi_timer_core_fixture.hpp"

namespace armature::test::axi_timer {
namespace {

class AxiTimerLevels : public CoreFixture<Vtimer_core_low> {
 protected:
  void SetUp() override { start(0x3, false); }
};

TEST_F(AxiTimerLevels, GenerateOutIdlesHighAndPulsesLow) {
  for (unsigned timer = 0; timer < 2; ++timer) {
    EXPECT_EQ(dut_.generate_o, 0x3u);
    load(timer, 3);
    write_tcsr(timer, kRun | kDown | kGenerate);
    EXPECT_EQ(when(20, [&] { return !pulse(timer); }), std::vector<std::int64_t>{4});
  }
}

TEST_F(AxiTimerLevels, FallingEdgeCaptures) {
  for (unsigned timer = 0; timer < 2; ++timer) {
    write_tcsr(timer, kRun | kCapture | kCapturePin);
    tick(10);
    EXPECT_FALSE(flag(timer)) << "an idle pin is no edge";
    dut_.capture_trig_i = static_cast<CData>(0x3u & ~(1u << timer));
    tick(4);
    EXPECT_EQ(tlr(timer), 13u);
    EXPECT_TRUE(flag(timer));
    write_tcsr(timer, kRun | kCapture | kCapturePin | kFlag);
    dut_.capture_trig_i = 0x3;
    tick(10);
    EXPECT_FALSE(flag(timer)) << "the rising edge";
  }
}

TEST_F(AxiTimerLevels, PwmIsActiveHighAllTheSame) {
  load(0, 10, kPwm | kGenerate | kDown | kReload);
  load(1, 3, kPwm | kGenerate | kDown | kReload);
  write_tcsr(0, kPwm | kGenerate | kDown | kReload | kRunAll);
  EXPECT_EQ(when(23, [&] { return dut_.pwm_o != 0; }), (std::vector<std::int64_t>{11, 12, 13, 14, 15, 23}));
}

}  // namespace
}  // namespace armature::test::axi_timer
