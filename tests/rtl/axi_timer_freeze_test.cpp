// The freeze pin: both counters stand still, and nothing else does.
#include "tests/rtl/axi_timer_core_fixture.hpp"

namespace armature::test::axi_timer {
namespace {

using AxiTimerFreeze = CoreFixture<Vtimer_core>;

TEST_F(AxiTimerFreeze, StopsAndContinuesBothCountersTwoClocksLater) {
  load(1, 1000, kDown);
  write_tcsr(0, kRunAll);
  tick(20);
  const std::uint32_t up = tcr(0), down = tcr(1);
  dut_.freeze_i = 1;
  tick(30);
  EXPECT_EQ(tcr(0), up + kSyncClocks);
  EXPECT_EQ(tcr(1), down - kSyncClocks);
  dut_.freeze_i = 0;
  tick(kSyncClocks);
  EXPECT_EQ(tcr(0), up + kSyncClocks);
  tick(5);
  EXPECT_EQ(tcr(0), up + kSyncClocks + 5);
  EXPECT_EQ(tcr(1), down - kSyncClocks - 5);
}

// Whatever clock it begins in: no pulse is lost or doubled, the period grows by the length of the freeze.
TEST_F(AxiTimerFreeze, StretchesThePeriodByItsLength) {
  constexpr std::int64_t kLength = 7;
  for (std::int64_t begin = 0; begin <= 14; ++begin) {
    load(0, 5, kDown);
    write_tcsr(0, kRun | kDown | kReload | kGenerate);
    std::vector<std::int64_t> expected;
    for (const std::int64_t clock : {6, 13, 20}) {
      expected.push_back(clock <= begin + kSyncClocks ? clock : clock + kLength);
    }
    std::vector<std::int64_t> found;
    for (std::int64_t clock = 1; clock <= 20 + kLength; ++clock) {
      dut_.freeze_i = clock > begin && clock <= begin + kLength;
      tick();
      if (pulse(0)) found.push_back(clock);
    }
    EXPECT_EQ(found, expected) << "freeze after clock " << begin;
    write_tcsr(0, 0);
  }
}

TEST_F(AxiTimerFreeze, RegistersLoadAndCaptureStillWork) {
  write_tcsr(0, kRun | kCapture | kCapturePin);
  tick(10);
  dut_.freeze_i = 1;
  tick(5);
  const std::uint32_t frozen = tcr(0);
  dut_.capture_trig_i = 1;
  tick(5);
  EXPECT_EQ(tlr(0), frozen);
  EXPECT_TRUE(flag(0));
  write_tcsr(0, kRun | kFlag | kLoad);
  EXPECT_FALSE(flag(0));
  write_tlr(0, 77);
  tick();
  EXPECT_EQ(tcr(0), 77u);
}

TEST_F(AxiTimerFreeze, StopsACascade) {
  load(0, kMax);
  load(1, 5);
  write_tcsr(0, kCascade | kRun);
  dut_.freeze_i = 1;
  tick(kSyncClocks);
  EXPECT_EQ(tcr(0), 1u);
  tick(20);
  EXPECT_EQ(tcr(0), 1u);
  EXPECT_EQ(tcr(1), 6u);
}

}  // namespace
}  // namespace armature::test::axi_timer
