// ENALL: one bit of both TCSRs that starts both timers on one edge.
#include "tests/rtl/axi_timer_core_fixture.hpp"

namespace armature::test::axi_timer {
namespace {

using AxiTimerEnall = CoreFixture<Vtimer_core>;

TEST_F(AxiTimerEnall, WritingOneToEitherTcsrSetsItAndEntInBoth) {
  for (unsigned timer = 0; timer < 2; ++timer) {
    write_tcsr(0, 0);
    write_tcsr(1, 0);
    write_tcsr(timer, kRunAll | kReload);
    EXPECT_EQ(tcsr(timer), kRunAll | kRun | kReload) << "ENT is set although the write has 0 there";
    EXPECT_EQ(tcsr(1 - timer), kRunAll | kRun);
  }
}

TEST_F(AxiTimerEnall, WritingZeroClearsItAloneInBoth) {
  for (unsigned timer = 0; timer < 2; ++timer) {
    write_tcsr(0, kRunAll);
    write_tcsr(timer, kRun);
    EXPECT_EQ(tcsr(0), kRun);
    EXPECT_EQ(tcsr(1), kRun);
    write_tcsr(0, kRunAll);
    write_tcsr(timer, 0);
    EXPECT_EQ(tcsr(timer), 0u) << "ENT of the written TCSR follows its own bit";
    EXPECT_EQ(tcsr(1 - timer), kRun);
  }
}

TEST_F(AxiTimerEnall, StartsBothOnOneEdge) {
  load(0, 100, kDown);
  load(1, 50, kDown);
  write_tcsr(1, kDown | kRun | kRunAll);
  for (std::uint32_t i = 1; i <= 20; ++i) {
    tick();
    EXPECT_EQ(tcr(0), 100 - i);
    EXPECT_EQ(tcr(1), 50 - i);
  }
}

// A read-modify-write of TCSR with the bit still set starts a timer that it meant to stop. That is how the core
// behaves.
TEST_F(AxiTimerEnall, ReadModifyWriteStartsAgain) {
  write_tcsr(0, kRunAll | kReload);
  write_tcsr(0, tcsr(0) & ~kRun);
  EXPECT_EQ(tcsr(0), kRunAll | kRun | kReload);
  const std::uint32_t count = tcr(1);
  write_tcsr(1, tcsr(1) & ~kRun);
  tick(10);
  EXPECT_GT(tcr(1), count);
  write_tcsr(0, kReload);
  write_tcsr(1, 0);
  EXPECT_EQ(tcsr(0), kReload) << "stops with the bit written 0";
  EXPECT_EQ(tcsr(1), 0u);
}

TEST_F(AxiTimerEnall, ActsAtTheWriteOnly) {
  write_tcsr(0, kRunAll);
  write_tcsr(1, 0, 0x1);  // ENT1 alone; ENALL lives in byte 1
  EXPECT_EQ(tcsr(1), kRunAll);
  tick(20);
  EXPECT_EQ(tcsr(1), kRunAll);
  EXPECT_EQ(tcsr(0), kRunAll | kRun);
}

TEST_F(AxiTimerEnall, LivesInByteOne) {
  write_tcsr(0, kRunAll, 0xD);
  EXPECT_EQ(tcsr(0), 0u);
  EXPECT_EQ(tcsr(1), 0u);
  write_tcsr(0, kRunAll | kDown | kLoad, 0x2);
  EXPECT_EQ(tcsr(0), kRunAll | kRun) << "byte 0 was not strobed";
  EXPECT_EQ(tcsr(1), kRunAll | kRun);
}

TEST_F(AxiTimerEnall, UnimplementedBitsReadZero) {
  write_tcsr(0, ~(kRun | kRunAll | kCascade | kPwm));
  write_tcsr(1, ~(kRun | kRunAll));
  EXPECT_EQ(tcsr(0), 0x7Fu);
  EXPECT_EQ(tcsr(1), kPwm | 0x7Fu) << "CASC is a bit of TCSR0 alone";
}

}  // namespace
}  // namespace armature::test::axi_timer
