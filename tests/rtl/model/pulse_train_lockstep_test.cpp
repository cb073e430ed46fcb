// pulse_train and its model, clock for clock.
#include <algorithm>
#include <array>
#include <string>

#include "Vpulse_train.h"
#include "controller/regs/pulse_train_regs.hpp"
#include "cosim/model/pulse_train/pulse_train.hpp"
#include "tests/rtl/model/block_lockstep.hpp"

namespace armature::test {
namespace {

namespace regs = armature::regs::pulse_train;
using cosim::model::PulseInputs;
using cosim::model::PulseTrain;

class PulseTrainLockstep : public BlockLockstep<Vpulse_train, PulseTrain, PulseInputs> {
 protected:
  struct Style {
    std::uint32_t shortest_tick, longest_tick;  // edges between triggers
    std::uint32_t largest_count;
    std::uint32_t pins_rest;   // 1 of so many edges changes a pin
    std::uint32_t stops_rest;  // 1 of so many writes is one that stops, likewise protects
  };

  BusTraffic random_write() override {
    const std::uint32_t kind = random_.below(style_.stops_rest);
    if (kind == 0) return {regs::kEstopOffset, random_.below(8)};
    if (kind == 1) return {regs::kKeyOffset, random_.below(2) == 0 ? regs::kKeyWord : random_.below(2)};
    if (kind == 2) return odd_write();
    if (kind == 3) return {regs::kFaultOffset, random_.below(64)};
    if (kind == 4) return timing_write();
    if (kind == 5) return {regs::kCtrlOffset, random_.below(64) | (random_.below(8) != 0 ? regs::kCtrlRunMask : 0u)};
    if (kind <= 8) return {regs::kEstopOffset, regs::kEstopClearEstopMask | regs::kEstopClearWatchdogMask};
    if (commits_ == 0) {
      commits_ = 1 + random_.below(7);
      return {regs::kCommitOffset, static_cast<std::uint32_t>(random_.next())};
    }
    --commits_;
    const std::uint32_t size = random_.below(4) == 0 ? 0 : random_.below(style_.largest_count + 1);
    const std::uint32_t count = random_.below(2) == 0 ? size : ~size + 1;
    return {static_cast<std::uint16_t>(regs::kCountOffset + 4 * random_.below(6)), count & 0xFFFF};
  }

  BusTraffic timing_write() {
    switch (random_.below(5)) {
      case 0:
        return {regs::kTickCyclesOffset, style_.shortest_tick + random_.below(style_.longest_tick)};
      case 1:
        return {regs::kDirSetupOffset, random_.below(random_.below(2) == 0 ? 8 : 64)};
      case 2:
        return {regs::kDirHoldOffset, random_.below(random_.below(2) == 0 ? 8 : 64)};
      case 3:
        return {regs::kWatchdogOffset, random_.below(6)};
      default:
        return {regs::kTickCyclesOffset, random_.below(4)};
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

  void drive_inputs(Vpulse_train& dut, const PulseInputs& in) override {
    dut.trigger_i = in.trigger;
    dut.estop_ni = in.estop_n;
    dut.home_i = in.home;
    dut.limit_pos_i = in.limit_pos;
    dut.limit_neg_i = in.limit_neg;
    dut.drive_alarm_i = in.drive_alarm;
    dut.in_position_i = in.in_position;
  }

  std::string difference(const Vpulse_train& dut, const PulseTrain& block) override {
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
  std::uint32_t commits_ = 0;
  unsigned step_before_ = 0, dir_before_ = 0, beat_before_ = 0;
  int rises_ = 0, turns_ = 0, beats_ = 0;  // seen
};

TEST_F(PulseTrainLockstep, RandomTrafficOnShortTicks) {
  for (const std::uint32_t rest : {12u, 40u, 200u}) {
    style_ = {
        .shortest_tick = 20, .longest_tick = 300, .largest_count = 12, .pins_rest = 10 * rest, .stops_rest = rest};
    run(150'000, 3, 1);
  }
  EXPECT_GT(rises_, 5'000);
  EXPECT_GT(turns_, 1'000);
  EXPECT_GT(beats_, 1'000);
}

TEST_F(PulseTrainLockstep, RandomTrafficOnTicksOfFiftyMicroseconds) {
  style_ = {.shortest_tick = 2400, .longest_tick = 200, .largest_count = 220, .pins_rest = 3000, .stops_rest = 100};
  run(400'000, 40, 2);
  EXPECT_GT(rises_, 10'000);
}

TEST_F(PulseTrainLockstep, FewEdgesNeedToBeComputed) {
  style_ = {.shortest_tick = 2500, .longest_tick = 1, .largest_count = 3, .pins_rest = 1'000'000, .stops_rest = 1'000};
  run(200'000, 300, 1);
  EXPECT_GT(beats_, 10);
  EXPECT_LT(needed_.computed, 200'000 / 20) << "of 200000 edges";
}

TEST_F(PulseTrainLockstep, AGatedClockThatStops) {
  style_ = {.shortest_tick = 200, .longest_tick = 300, .largest_count = 12, .pins_rest = 100'000, .stops_rest = 1'000};
  run(5'000, 3, 1);
  const int before = rises_;
  stop_gated_clock();
  run(20'000, 3, 1);
  EXPECT_GT(rises_, before) << "the generators continue";
}

}  // namespace
}  // namespace armature::test
