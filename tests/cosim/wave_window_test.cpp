#include "cosim/kernel/wave_window.hpp"

#include <gtest/gtest.h>

#include "tests/support/fake_fabric.hpp"

namespace armature::cosim {
namespace {

using Log = std::vector<std::string>;

TEST(WaveWindow, WithoutARequestDoesNothing) {
  FakeFabric fabric;
  WaveWindow window{std::nullopt};
  EXPECT_FALSE(window.next_event());
  window.advance(Cycles{0}, fabric);
  window.fault(Cycles{5}, fabric);
  EXPECT_TRUE(fabric.log.empty());
}

TEST(WaveWindow, OpensAndClosesOnTheCycle) {
  FakeFabric fabric;
  WaveWindow window{WaveRequest{.file = "a.vcd", .format = {}, .from = Cycles{100}, .to = Cycles{200}}};
  EXPECT_EQ(window.next_event(), Cycles{100});
  window.advance(Cycles{99}, fabric);
  EXPECT_TRUE(fabric.log.empty());
  window.advance(Cycles{100}, fabric);
  EXPECT_EQ(window.next_event(), Cycles{200});
  window.advance(Cycles{200}, fabric);
  EXPECT_FALSE(window.next_event());
  EXPECT_EQ(fabric.log, (Log{"open a.vcd", "close"}));
}

TEST(WaveWindow, WithoutLimitsCoversTheWholeRun) {
  FakeFabric fabric;
  WaveWindow window{WaveRequest{.file = "a.vcd", .format = {}, .from = {}, .to = {}}};
  EXPECT_EQ(window.next_event(), Cycles{0});
  window.advance(Cycles{0}, fabric);
  EXPECT_FALSE(window.next_event());
  EXPECT_EQ(fabric.log, (Log{"open a.vcd"}));
}

TEST(WaveWindow, OnFaultOpensOnceAtTheFirstFaultForOneMillisecond) {
  FakeFabric fabric;
  WaveWindow window{WaveRequest{.file = "a.fst", .format = {}, .from = Cycles{50}, .to = {}, .on_fault = true}};
  EXPECT_FALSE(window.next_event());
  window.fault(Cycles{49}, fabric);  // before the window
  EXPECT_TRUE(fabric.log.empty());
  window.fault(Cycles{60}, fabric);
  window.fault(Cycles{61}, fabric);
  EXPECT_EQ(window.next_event(), Cycles{60 + 50'000});
  window.advance(Cycles{60 + 50'000}, fabric);
  window.fault(Cycles{90'000}, fabric);
  EXPECT_EQ(fabric.log, (Log{"open a.fst", "close"}));
}

}  // namespace
}  // namespace armature::cosim
