// A healthy stand-in for the logic and the software around the conservation checker, with a plant; each part can lie.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <deque>
#include <optional>

#include "controller/base/axes.hpp"
#include "controller/regs/encoder_regs.hpp"
#include "controller/regs/pulse_train_regs.hpp"
#include "controller/regs/soc_map.hpp"
#include "cosim/check/conservation.hpp"
#include "cosim/plant/plant.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

using CountSet = PerAxis<std::int32_t>;

inline constexpr CountSet kNone{};  // no pulses

[[nodiscard]] constexpr CountSet with(CountSet set, std::size_t axis, std::int32_t count) {
  set[axis] = count;
  return set;
}

#define EXPECT_VIOLATION(bench, text)            \
  do {                                           \
    ASSERT_TRUE((bench).check.violation());      \
    EXPECT_EQ(*(bench).check.violation(), text); \
  } while (false)
#define EXPECT_CONSERVED(bench) EXPECT_FALSE((bench).check.violation()) << *(bench).check.violation()

class ConservationBench {
 public:
  static constexpr std::int64_t kTick = regs::soc::kTickCycles;
  static constexpr std::size_t kEncoderLatency = 8;  // of the stand-in: synchroniser, 5 cycles of debounce, position
  static constexpr std::size_t kHistory = 300;       // cycles

  Plant plant;
  Conservation check;
  bool plant_sees_steps = true;     // false: the drives miss what is on the pins
  std::uint8_t servo_wires = 0x3F;  // servo-enable lines that are not cut between the pins and the drives

  // `logic`: the registers that the software talks to, and its input jitter. `drop_out`: time of the relay; the
  // heartbeat stands still. `start_deg`: of the joints.
  explicit ConservationBench(CheckedLogic logic = {}, std::optional<Cycles> drop_out = std::nullopt,
                             const PerAxis<double>& start_deg = {})
      : plant{RobotSpec{}, drop_out, start_deg}, check{plant, BusSpec{}, logic} {
    set_servo(0x3F);
  }
  ConservationBench(const ConservationBench&) = delete;  // the checker refers to the plant
  ConservationBench& operator=(const ConservationBench&) = delete;

  [[nodiscard]] Cycles now() const { return now_; }
  [[nodiscard]] Cycles trigger() const { return trigger_; }

  void set_servo(std::uint8_t servo_on) {
    out_.servo_on = servo_on;
    show();
  }

  // ---- software
  void write(std::uint32_t addr, std::uint32_t data) { check.on_write(now_, addr, data); }
  void read(std::uint32_t addr, std::uint32_t data) { check.on_read(now_, addr, data); }

  void commit(const CountSet& counts) {
    namespace pt = regs::pulse_train;
    for (std::uint32_t axis = 0; axis < kAxes; ++axis) {
      write(pulse_train(pt::kCountOffset) + axis * pt::kCountStride, static_cast<std::uint32_t>(counts[axis]));
    }
    write(pulse_train(pt::kCommitOffset), 1);
  }

  void read_fault(std::uint32_t flags) { read(pulse_train(regs::pulse_train::kFaultOffset), flags); }

  void read_emitted(std::size_t axis, std::int64_t value) {
    read(pulse_train(regs::pulse_train::kEmittedOffset) + static_cast<std::uint32_t>(4 * axis),
         static_cast<std::uint32_t>(value));
  }

  void read_position(std::size_t axis, std::int64_t value) {
    read(encoder(regs::encoder::kPositionOffset) + static_cast<std::uint32_t>(4 * axis),
         static_cast<std::uint32_t>(value));
  }

  static constexpr std::uint32_t pulse_train(std::uint32_t offset) { return regs::soc::kPulseTrainBase + offset; }
  static constexpr std::uint32_t encoder(std::uint32_t offset) { return regs::soc::kEncoderBase + offset; }

  // ---- logic
  void wait(std::int64_t cycles) {
    for (std::int64_t i = 0; i < cycles; ++i) next_cycle();
  }

  // The clock of the logic stands still. The plant continues.
  void stand_still(std::int64_t cycles) {
    check.on_clock(now_, false);
    for (std::int64_t i = 0; i < cycles; ++i) {
      now_ += Cycles{1};
      trigger_ += Cycles{1};  // the tick continues where it was
      if (plant.next_event() <= now_) plant.advance(now_);
    }
    check.on_clock(now_, true);
  }

  // Waits for the next trigger, which starts the pulses of `counts`. Returns after `after` cycles of the new tick.
  void begin_tick(const CountSet& counts, std::int64_t after = 500) {
    while (now_ < trigger_ + Cycles{kTick}) next_cycle();
    trigger_ = now_;
    counts_ = counts;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (counts[axis] != 0) set_bit(next_dir_, axis, (counts[axis] > 0) == kDirForward);
    }
    out_.trigger = true;
    show();
    check.on_trigger(now_);
    at_trigger_ = history_;
    emitted_at_trigger = emitted_;
    wait(after);
  }

  // The encoder's count so many cycles before the last trigger.
  [[nodiscard]] std::int64_t count_before_trigger(std::size_t axis, std::size_t age) const {
    return age < at_trigger_.size() ? at_trigger_[at_trigger_.size() - 1 - age][axis] : 0;
  }
  // What healthy snapshot registers show.
  [[nodiscard]] std::int64_t position_at_trigger(std::size_t axis) const {
    return count_before_trigger(axis, kEncoderLatency);
  }
  PerAxis<std::int64_t> emitted_at_trigger{};

 private:
  void next_cycle() {
    now_ += Cycles{1};
    const SocOutputs before = out_;
    const std::int64_t cycle = (now_ - trigger_).value();
    out_.trigger = false;
    if (cycle == 60) out_.dir = next_dir_;
    // Pulses of 6 cycles every 12 from cycle 90 on: room for 200.
    const std::int64_t slot = (cycle - 90) / 12;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const bool pulse = cycle >= 90 && slot < std::abs(counts_[axis]) && (cycle - 90) % 12 < 6;
      if (pulse && ((out_.step >> axis) & 1) == 0) emitted_[axis] += counts_[axis] > 0 ? 1 : -1;
      set_bit(out_.step, axis, pulse);
    }
    if (!(out_ == before)) show();
    if (plant.next_event() <= now_) plant.advance(now_);
    PerAxis<std::int64_t> counts;
    for (std::size_t axis = 0; axis < kAxes; ++axis) counts[axis] = plant.motor_counts(axis).value();
    history_.push_back(counts);
    if (history_.size() > kHistory) history_.pop_front();
  }

  void show() {
    SocOutputs to_plant = out_;
    to_plant.servo_on &= servo_wires;
    if (!plant_sees_steps) to_plant.step = 0;
    plant.on_outputs(now_, to_plant);
    check.on_outputs(now_, out_);
  }

  Cycles now_{1000};
  Cycles trigger_{1000};
  SocOutputs out_;
  std::uint8_t next_dir_ = 0;
  CountSet counts_{};
  PerAxis<std::int64_t> emitted_{};
  std::deque<PerAxis<std::int64_t>> history_, at_trigger_;
};

}  // namespace armature::cosim
