// pulse_width and its model, clock for clock.
#include <algorithm>
#include <array>
#include <string>

#include "Vpulse_width.h"
#include "controller/regs/pulse_width_regs.hpp"
#include "cosim/model/paper/pulse_width.hpp"
#include "tests/rtl/model/block_lockstep.hpp"

namespace armature::test {
namespace {

namespace regs = armature::regs::pulse_width;
using cosim::model::PulseInputs;
using cosim::model::PulseWidth;

class PulseWidthLockstep : public BlockLockstep<Vpulse_width, PulseWidth, PulseInputs> {
 protected:
  struct Style {
    std::uint32_t shortest_tick, longest_tick;  // edges between triggers
    std::uint32_t largest_width;
    std::uint32_t pins_rest;   // 1 of so many edges changes a pin
    std::uint32_t stops_rest;  // 1 of so many writes is one that stops, or clears
  };

  BusTraffic random_write() override {
    switch (random_.below(style_.stops_rest)) {
      case 0:
        return {regs::kEstopOffset, random_.below(4)};
      case 1:
        return odd_write();
      case 2:
        return {regs::kFaultOffset, random_.below(2)};
      case 3:
        return {regs::kCtrlOffset, random_.below(64)};
      case 4:
      case 5:
        return {regs::kEstopOffset, regs::kEstopClearEstopMask};
      default: {
        const std::uint32_t size = random_.below(4) == 0 ? 0 : random_.below(style_.largest_width + 1);
        const std::uint32_t width = random_.below(2) == 0 ? size : 0u - size;
        return {static_cast<std::uint16_t>(regs::kWidthOffset + 4 * random_.below(6)), width};
      }
    }
  }

  // Any offset, any bytes.
  BusTraffic odd_write() {
    return {static_cast<std::uint16_t>(random_.below(random_.below(8) == 0 ? 0x10000 : 0xD0)),
            static_cast<std::uint32_t>(random_.next()), static_cast<std::uint8_t>(random_.below(16))};
  }

  std::uint16_t random_read() override {
    return static_cast<std::uint16_t>(random_.below(random_.below(16) == 0 ? 0x10000 : 0xC0));
  }

  void change_inputs() override {
    inputs_.trigger = to_trigger_ == 0;
    if (to_trigger_ == 0) to_trigger_ = style_.shortest_tick + random_.below(style_.longest_tick);
    if (random_.below(16) != 0 || !inputs_.trigger) --to_trigger_;  // now and then a trigger of two clocks
    if (random_.below(style_.pins_rest) != 0) return;
    const auto bits = [&] { return static_cast<std::uint8_t>(random_.below(64)); };
    switch (random_.below(6)) {
      case 0:
        inputs_.home = bits();
        break;
      case 1:
        inputs_.limit_pos = bits();
        break;
      case 2:
        inputs_.limit_neg = bits();
        break;
      case 3:
        inputs_.drive_alarm = bits();
        break;
      case 4:
        inputs_.in_position = bits();
        break;
      default:
        inputs_.estop_n = !inputs_.estop_n || random_.below(8) != 0;
    }
  }

  void drive_inputs(Vpulse_width& dut, const PulseInputs& in) override {
    dut.trigger_i = in.trigger;
    dut.estop_ni = in.estop_n;
    dut.home_i = in.home;
    dut.limit_pos_i = in.limit_pos;
    dut.limit_neg_i = in.limit_neg;
    dut.drive_alarm_i = in.drive_alarm;
    dut.in_position_i = in.in_position;
  }

  std::string difference(const Vpulse_width& dut, const PulseWidth& block) override {
    const auto differs = [](const char* name, unsigned rtl, unsigned model) {
      return rtl == model ? std::string{}
                          : std::string{name} + " RTL " + std::to_string(rtl) + " model " + std::to_string(model);
    };
    rises_ += static_cast<int>(std::popcount(dut.step_o & ~step_before_ & 0x3Fu));
    turns_ += static_cast<int>(std::popcount((dut.dir_o ^ dir_before_) & 0x3Fu));
    beats_ += dut.heartbeat_o != beat_before_;
    step_before_ = dut.step_o;
    dir_before_ = dut.dir_o;
    beat_before_ = dut.heartbeat_o;
    return differs("step_o", dut.step_o, block.step()) + differs("dir_o", dut.dir_o, block.dir()) +
           differs("servo_on_o", dut.servo_on_o, block.servo_on()) +
           differs("heartbeat_o", dut.heartbeat_o, block.heartbeat());
  }

  Style style_{};
  std::uint32_t to_trigger_ = 10;
  unsigned step_before_ = 0, dir_before_ = 0, beat_before_ = 0;
  int rises_ = 0, turns_ = 0, beats_ = 0;  // seen
};

TEST_F(PulseWidthLockstep, RandomTrafficOnShortTicks) {
  for (const std::uint32_t rest : {12u, 40u, 200u}) {
    style_ = {
        .shortest_tick = 20, .longest_tick = 300, .largest_width = 12, .pins_rest = 10 * rest, .stops_rest = rest};
    run(150'000, 3, 1);
  }
  EXPECT_GT(rises_, 5'000);
  EXPECT_GT(turns_, 1'000);
  EXPECT_GT(beats_, 1'000);
}

TEST_F(PulseWidthLockstep, RandomTrafficOnTicksOfFiftyMicroseconds) {
  style_ = {.shortest_tick = 2400, .longest_tick = 200, .largest_width = 220, .pins_rest = 3000, .stops_rest = 100};
  run(400'000, 40, 2);
  EXPECT_GT(rises_, 10'000);
}

TEST_F(PulseWidthLockstep, FewEdgesNeedToBeComputed) {
  style_ = {
      .shortest_tick = 2500, .longest_tick = 1, .largest_width = 2'000, .pins_rest = 1'000'000, .stops_rest = 1'000};
  run(200'000, 300, 1);
  EXPECT_GT(beats_, 10);
  EXPECT_LT(needed_.computed, 200'000 / 20) << "of 200000 edges";
}

TEST_F(PulseWidthLockstep, AGatedClockThatStops) {
  style_ = {.shortest_tick = 200, .longest_tick = 300, .largest_width = 12, .pins_rest = 100'000, .stops_rest = 1'000};
  run(5'000, 3, 1);
  const int before = rises_;
  stop_gated_clock();
  run(20'000, 3, 1);
  EXPECT_GT(rises_, before) << "the generators continue";
}

}  // namespace
}  // namespace armature::test
