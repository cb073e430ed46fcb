#include "cosim/kernel/wave_window.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "cosim/soc/pin_soc.hpp"
#include "tests/support/fake_fabric.hpp"

namespace armature::cosim {
namespace {

using Log = std::vector<std::string>;

struct FakeChip {
  explicit FakeChip(std::unique_ptr<FakeFabric> fabric = std::make_unique<FakeFabric>())
      : log{fabric->log}, soc{std::move(fabric), BusSpec{}, 1} {}
  const Log& log;  // what was asked of the waveform
  PinSoc soc;
};

TEST(WaveWindow, WithoutARequestDoesNothing) {
  FakeChip chip;
  WaveWindow window{std::nullopt};
  EXPECT_FALSE(window.next_event());
  window.advance(Cycles{0}, chip.soc);
  window.advance(Cycles{5}, chip.soc);
  EXPECT_TRUE(chip.log.empty());
}

TEST(WaveWindow, OpensAndClosesOnTheCycle) {
  FakeChip chip;
  WaveWindow window{WaveRequest{.file = "a.vcd", .format = {}, .from = Cycles{100}, .to = Cycles{200}}};
  EXPECT_EQ(window.next_event(), Cycles{100});
  window.advance(Cycles{99}, chip.soc);
  EXPECT_TRUE(chip.log.empty());
  window.advance(Cycles{100}, chip.soc);
  EXPECT_EQ(window.next_event(), Cycles{200});
  window.advance(Cycles{200}, chip.soc);
  EXPECT_FALSE(window.next_event());
  EXPECT_EQ(chip.log, (Log{"open a.vcd", "close"}));
}

TEST(WaveWindow, WithoutLimitsCoversTheWholeRun) {
  FakeChip chip;
  WaveWindow window{WaveRequest{.file = "a.vcd", .format = {}, .from = {}, .to = {}}};
  EXPECT_EQ(window.next_event(), Cycles{0});
  window.advance(Cycles{0}, chip.soc);
  EXPECT_FALSE(window.next_event());
  EXPECT_EQ(chip.log, (Log{"open a.vcd"}));
}

}  // namespace
}  // namespace armature::cosim
