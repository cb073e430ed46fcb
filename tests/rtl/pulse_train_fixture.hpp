// Fixture of pulse_train with its AXI port, a tick timer and a drive on each axis.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "controller/regs/field.hpp"
#include "controller/regs/pulse_train_regs.hpp"
#include "tests/support/axi_lite_driver.hpp"
#include "tests/support/step_dir_monitor.hpp"
#include "tests/support/verilated_test.hpp"

namespace armature::test {

inline constexpr int kAxes = 6;
inline constexpr int kAllAxes = 0x3F;
inline constexpr int kMaxCount = 200;

using AxisCounts = std::array<int, kAxes>;

template <class Dut>
class PulseTrainFixture : public VerilatedTest<Dut> {
 protected:
  PulseTrainFixture() { restart(); }

  void restart() {
    this->dut_.estop_ni = 1;
    this->dut_.trigger_i = 0;
    this->dut_.home_i = this->dut_.limit_pos_i = this->dut_.limit_neg_i = 0;
    this->dut_.drive_alarm_i = this->dut_.in_position_i = 0;
    this->reset();
    bus_.emplace(
        this->dut_, [this] { clock(); }, AxiStall::kNone, 1);
    to_trigger_ = period_ = 2500;
  }

  // One clock cycle, with the trigger from the tick timer.
  void clock() {
    const bool trigger = --to_trigger_ == 0;
    if (trigger) to_trigger_ = period_;
    this->dut_.trigger_i = trigger;
    this->tick();
    for (std::size_t i = 0; i < kAxes; ++i) {
      drives_[i].sample(this->cycle_, this->dut_.step_o >> i & 1, this->dut_.dir_o >> i & 1);
    }
    if (!trigger) return;
    trigger_edge_ = this->cycle_;
    ++ticks_;
    at_trigger_ = positions();
    trigger_positions_.push_back(at_trigger_);
  }

  void clock(int cycles) {
    for (int i = 0; i < cycles; ++i) clock();
  }

  // Runs until after the next trigger edge.
  void run_to_trigger() {
    for (const auto before = ticks_; ticks_ == before;) clock();
  }

  void write(std::uint32_t offset, std::uint32_t value) { EXPECT_EQ(bus_->write(offset, value), AxiResp::kOkay); }

  [[nodiscard]] std::uint32_t read(std::uint32_t offset) {
    const AxiReadResult result = bus_->read(offset);
    EXPECT_EQ(result.resp, AxiResp::kOkay);
    return result.data;
  }

  [[nodiscard]] std::int32_t read_axis(std::uint32_t first, int axis) {
    return static_cast<std::int32_t>(read(first + 4 * static_cast<std::uint32_t>(axis)));
  }

  void stage(const AxisCounts& counts) {
    for (std::size_t i = 0; i < kAxes; ++i) {
      write(regs::pulse_train::kCountOffset + 4 * static_cast<std::uint32_t>(i),
            static_cast<std::uint32_t>(counts[i]) & 0xFFFF);
    }
  }

  void commit(std::uint16_t sequence) { write(regs::pulse_train::kCommitOffset, sequence); }

  void stage_and_commit(const AxisCounts& counts, std::uint16_t sequence = 1) {
    stage(counts);
    commit(sequence);
  }

  [[nodiscard]] AxisCounts positions() const {
    AxisCounts result;
    for (std::size_t i = 0; i < kAxes; ++i) result[i] = static_cast<int>(drives_[i].position);
    return result;
  }

  [[nodiscard]] std::int64_t rises() const {
    std::int64_t sum = 0;
    for (const auto& drive : drives_) sum += drive.rises;
    return sum;
  }

  [[nodiscard]] std::uint32_t status() { return read(regs::pulse_train::kStatusOffset); }
  [[nodiscard]] std::uint32_t faults() { return read(regs::pulse_train::kFaultOffset); }
  [[nodiscard]] std::uint32_t sequence() { return regs::extract(status(), regs::pulse_train::kStatusSequence); }

  // TIME in the cycle that ended with clock edge `edge`.
  static std::uint32_t time_of(std::int64_t edge) { return static_cast<std::uint32_t>(edge - 1); }

  int period_ = 2500;  // cycles from one trigger to the next
  int to_trigger_ = 0;
  int ticks_ = 0;
  std::int64_t trigger_edge_ = 0;
  AxisCounts at_trigger_{};                    // drive positions right after the last trigger edge
  std::vector<AxisCounts> trigger_positions_;  // of every trigger so far
  std::array<StepDirMonitor, kAxes> drives_;
  std::optional<AxiLiteDriver<Dut>> bus_;
};

}  // namespace armature::test
