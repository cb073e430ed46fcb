// Capture mode: what an edge of a capture pin stores, when it counts, and that roll-overs are no events.
#include "tests/rtl/axi_timer_core_fixture.hpp"

namespace armature::test::axi_timer {
namespace {

constexpr std::uint32_t kCaptureMode = kCapture | kCapturePin | kRun;
constexpr std::uint32_t kBefore = 0x5EED'0000u;  // TLR before the first capture

class AxiTimerCapture : public CoreFixture<Vtimer_core> {
 protected:
  void set_pin(unsigned timer, bool level) {
    dut_.capture_trig_i = static_cast<CData>((dut_.capture_trig_i & ~(1u << timer)) | (level ? 1u << timer : 0u));
  }
  // Raises the pin for four clocks and lowers it for four. Returns the value of TCR that belongs to the edge: the one
  // that shows when the synchronised edge does.
  std::uint32_t edge(unsigned timer) {
    set_pin(timer, true);
    tick(kEdgeClocks);
    const std::uint32_t value = tcr(timer);
    tick();
    set_pin(timer, false);
    tick(4);
    return value;
  }
};

TEST_F(AxiTimerCapture, StoresTheCountThreeClocksAfterThePinWasSampled) {
  for (unsigned timer = 0; timer < 2; ++timer) {
    for (const bool down : {false, true}) {
      load(timer, 1000);
      write_tlr(timer, kBefore);
      write_tcsr(timer, kCaptureMode | kFlag | (down ? kDown : 0u));
      tick(20);
      EXPECT_EQ(tcr(timer), down ? 980u : 1020u);
      set_pin(timer, true);
      tick(kEdgeClocks);
      EXPECT_EQ(tlr(timer), kBefore);
      EXPECT_FALSE(flag(timer));
      tick();
      EXPECT_EQ(tlr(timer), down ? 977u : 1023u);
      EXPECT_TRUE(flag(timer));
      EXPECT_EQ(tcr(timer), down ? 976u : 1024u) << "the count runs on";
      set_pin(timer, false);
      write_tcsr(timer, kFlag);
      tick(4);
    }
  }
}

TEST_F(AxiTimerCapture, OneClockIsLongEnoughAndALevelIsOneCapture) {
  write_tcsr(0, kCaptureMode | kReload);
  tick(10);
  set_pin(0, true);
  tick();
  set_pin(0, false);
  tick(4);
  const std::uint32_t first = tlr(0);
  EXPECT_EQ(first, 13u);
  tick(50);
  EXPECT_EQ(tlr(0), first);
  set_pin(0, true);
  tick(4);
  const std::uint32_t second = tlr(0);
  EXPECT_GT(second, first);
  tick(50);
  EXPECT_EQ(tlr(0), second) << "a high pin captures again";
  set_pin(0, false);
  tick(50);
  EXPECT_EQ(tlr(0), second) << "a falling edge captures";
}

TEST_F(AxiTimerCapture, WithoutArhtTheFirstCaptureStaysUntilTheFlagIsCleared) {
  write_tcsr(0, kCaptureMode);
  const std::uint32_t first = edge(0);
  EXPECT_EQ(tlr(0), first);
  edge(0);
  edge(0);
  EXPECT_EQ(tlr(0), first);
  EXPECT_TRUE(flag(0));
  write_tcsr(0, kCaptureMode | kFlag);
  EXPECT_EQ(tlr(0), first) << "clearing the flag captures nothing";
  const std::uint32_t second = edge(0);
  EXPECT_NE(second, first);
  EXPECT_EQ(tlr(0), second);
}

TEST_F(AxiTimerCapture, WithArhtEveryCaptureOverwrites) {
  write_tcsr(1, kCaptureMode | kReload);
  for (int i = 0; i < 4; ++i) {
    const std::uint32_t value = edge(1);
    EXPECT_EQ(tlr(1), value);
    EXPECT_TRUE(flag(1));
  }
}

// With ARHT the capture wins over the clear; without, the flag was still 1, and the capture is dropped.
TEST_F(AxiTimerCapture, CaptureInTheClockOfTheClear) {
  for (const bool overwrite : {false, true}) {
    const std::uint32_t mode = kCaptureMode | (overwrite ? kReload : 0u);
    for (int clear_at = 1; clear_at <= 6; ++clear_at) {  // the edge is in force in the fourth clock
      write_tcsr(0, mode | kFlag);
      edge(0);
      const std::uint32_t old = tlr(0);
      set_pin(0, true);
      tick(clear_at - 1);
      write_tcsr(0, mode | kFlag);
      tick(8 - clear_at);
      EXPECT_EQ(tlr(0) != old, overwrite || clear_at <= kEdgeClocks) << clear_at;
      EXPECT_EQ(flag(0), clear_at <= kEdgeClocks + (overwrite ? 1 : 0)) << clear_at;
      set_pin(0, false);
      tick(4);
    }
  }
}

TEST_F(AxiTimerCapture, NeedsModeCaptureEnableAndRun) {
  for (std::uint32_t mode = 0; mode < 8; ++mode) {
    const std::uint32_t bits = (mode & 1u ? kCapture : 0u) | (mode & 2u ? kCapturePin : 0u) | (mode & 4u ? kRun : 0u);
    load(0, 100);
    write_tlr(0, kBefore);
    write_tcsr(0, bits | kFlag);
    edge(0);
    EXPECT_EQ(flag(0), mode == 7) << mode;
    EXPECT_EQ(tlr(0) != kBefore, mode == 7) << mode;
    write_tcsr(0, kFlag);
  }
}

TEST_F(AxiTimerCapture, EdgeBeforeEntDoesNothingLater) {
  set_pin(0, true);
  tick(10);
  write_tlr(0, kBefore);
  write_tcsr(0, kCaptureMode);
  tick(20);
  EXPECT_EQ(tlr(0), kBefore);
  EXPECT_FALSE(flag(0));
}

TEST_F(AxiTimerCapture, EachTimerListensToItsOwnPin) {
  for (unsigned timer = 0; timer < 2; ++timer) {
    write_tcsr(0, kCaptureMode | kFlag);
    write_tcsr(1, kCaptureMode | kFlag);
    edge(timer);
    EXPECT_EQ(flag(0), timer == 0);
    EXPECT_EQ(flag(1), timer == 1);
  }
}

TEST_F(AxiTimerCapture, RollOverIsNoEventAndTheCountRunsOn) {
  for (const bool down : {false, true}) {
    load(0, before_end(down, 3));
    write_tlr(0, 500);
    write_tcsr(0, kCaptureMode | kReload | kGenerate | (down ? kDown : 0u));
    EXPECT_TRUE(pulses(0, 10).empty());
    EXPECT_FALSE(flag(0));
    EXPECT_EQ(tcr(0), down ? kMax - 6 : 6u);
    write_tcsr(0, 0);
  }
}

TEST_F(AxiTimerCapture, ACountThatWasHeldByAOneShotRunsOn) {
  load(0, 2);
  write_tcsr(0, kRun | kDown);
  tick(10);
  EXPECT_EQ(tcr(0), kMax);
  write_tcsr(0, kCaptureMode | kDown | kFlag);
  tick(10);
  EXPECT_EQ(tcr(0), kMax - 10);
  write_tcsr(0, kRun | kDown);
  tick(9);
  EXPECT_EQ(tcr(0), kMax - 20) << "and is not held again";
}

TEST_F(AxiTimerCapture, CaptureWinsOverAWriteOfTlrInTheSameClock) {
  write_tcsr(0, kCaptureMode);
  tick(5);
  set_pin(0, true);
  tick(kEdgeClocks);
  const std::uint32_t value = tcr(0);
  write_tlr(0, kBefore, 0x5);
  EXPECT_EQ(tlr(0), value);
  write_tlr(0, kBefore);
  EXPECT_EQ(tlr(0), kBefore);
}

TEST_F(AxiTimerCapture, RaisesTheInterruptIfEnit) {
  write_tcsr(0, kCaptureMode);
  edge(0);
  EXPECT_FALSE(dut_.irq_o);
  write_tcsr(0, kCaptureMode | kIrq | kFlag);
  set_pin(0, true);
  EXPECT_EQ(when(7, [&] { return dut_.irq_o != 0; }), (std::vector<std::int64_t>{5, 6, 7})) << "one after the flag";
}

TEST_F(AxiTimerCapture, PinsDoNothingInGenerateMode) {
  load(0, 100);
  write_tcsr(0, kRun | kDown | kReload | kCapturePin);
  edge(0);
  EXPECT_FALSE(flag(0));
  EXPECT_EQ(tlr(0), 100u);
}

}  // namespace
}  // namespace armature::test::axi_timer
