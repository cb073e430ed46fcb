// Fixture of encoder_core with six encoders on its pins. Positions are in counts. There is one index pulse per
// revolution, gated with the quadrature state 0.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "tests/support/synchroniser_jitter.hpp"
#include "tests/support/verilated_test.hpp"

namespace armature::test {

inline constexpr int kAxes = 6;
inline constexpr int kAllAxes = 0x3F;

// An encoder disc: A leads B when the position grows (Vo 2021, Table 1).
struct Disc {
  std::int64_t position = 0;
  int counts_per_rev = 40;

  [[nodiscard]] bool a() const { return phase() == 1 || phase() == 2; }
  [[nodiscard]] bool b() const { return phase() == 2 || phase() == 3; }
  [[nodiscard]] bool z() const { return position % counts_per_rev == 0; }

 private:
  [[nodiscard]] int phase() const { return static_cast<int>(position & 3); }
};

template <class Dut>
class EncoderFixture : public VerilatedTest<Dut> {
 protected:
  EncoderFixture() {
    this->dut_.trigger_i = 0;
    this->dut_.index_check_enable_i = 0;
    this->dut_.index_check_first_i = 0;
    this->dut_.filter_mode_i = 0;
    for (auto& disc : discs_) disc.position = 1;  // not at the index
    set_debounce(kDebounce);
    set_counts_per_rev(40);
    restart();
  }

  // Reset, then enough cycles for the filter to accept the levels of the discs.
  void restart() {
    jitter_.reset();
    drive_pins();
    this->reset();
    illegal_flags_ = index_flags_ = 0;
    clock(2 * this->debounce_ + 8);
    for (std::size_t i = 0; i < kAxes; ++i) start_[i] = discs_[i].position;
  }

  void set_debounce(int time) {
    debounce_ = time;
    this->dut_.debounce_time_i = static_cast<std::uint8_t>(time);
  }

  void set_counts_per_rev(int counts) {
    for (auto& disc : discs_) disc.counts_per_rev = counts;
    std::uint64_t bits = 0;  // packs 24-bit elements into words
    int filled = 0;
    std::size_t word = 0;
    for (int i = 0; i < kAxes; ++i) {
      bits |= static_cast<std::uint64_t>(counts) << filled;
      for (filled += 24; filled >= 32; filled -= 32, bits >>= 32) {
        this->dut_.counts_per_rev_value_i[word++] = static_cast<std::uint32_t>(bits);
      }
    }
    this->dut_.counts_per_rev_value_i[word] = static_cast<std::uint32_t>(bits);
  }

  // Levels of all lines: A of axis 1 in bit 0, then B, then Z.
  [[nodiscard]] std::uint32_t lines() const {
    int a = noise_a_, b = noise_b_, z = noise_z_;
    for (std::size_t i = 0; i < kAxes; ++i) {
      a ^= discs_[i].a() << i;
      b ^= discs_[i].b() << i;
      z ^= discs_[i].z() << i;
    }
    return static_cast<std::uint32_t>(z << 2 * kAxes | b << kAxes | a);
  }

  // From now on each edge of each line is sampled up to a clock late, at random.
  void start_jitter(std::uint64_t seed) { jitter_.emplace(seed, lines()); }

  void drive_pins() {
    const std::uint32_t lines = jitter_ ? jitter_->sample(this->lines()) : this->lines();
    this->dut_.enc_a_i = lines & kAllAxes;
    this->dut_.enc_b_i = lines >> kAxes & kAllAxes;
    this->dut_.enc_z_i = lines >> 2 * kAxes & kAllAxes;
  }

  // One cycle with the levels of the discs at the pins. The fixture models the sticky flags of the register file.
  void clock() {
    drive_pins();
    this->dut_.fault_illegal_i = illegal_flags_;
    this->dut_.fault_index_i = index_flags_;
    this->dut_.eval();
    const std::uint8_t illegal = this->dut_.fault_illegal_set_o;
    const std::uint8_t index = this->dut_.fault_index_set_o;
    this->tick();
    illegal_flags_ |= illegal;
    index_flags_ |= index;
  }

  void clock(int cycles) {
    for (int i = 0; i < cycles; ++i) clock();
  }

  // Turns the disc of one axis count by count, `cycles` apart, and waits until the last count has arrived.
  void turn(std::size_t axis, int counts, int cycles = 13) {
    for (int i = 0; i != counts; i += counts > 0 ? 1 : -1) {
      discs_[axis].position += counts > 0 ? 1 : -1;
      clock(cycles);
    }
    clock(debounce_ + 4);
  }

  void snapshot() {
    this->dut_.trigger_i = 1;
    clock();
    this->dut_.trigger_i = 0;
  }

  // Values of the last snapshot.
  [[nodiscard]] std::int32_t position(std::size_t axis) const {
    return static_cast<std::int32_t>(this->dut_.position_value_o[axis]);
  }
  [[nodiscard]] std::int32_t index_position(std::size_t axis) const {
    return static_cast<std::int32_t>(this->dut_.index_position_value_o[axis]);
  }
  [[nodiscard]] int illegal_count(std::size_t axis) const { return half(this->dut_.illegal_count_value_o, axis); }
  [[nodiscard]] int glitch_count(std::size_t axis) const { return half(this->dut_.glitch_count_value_o, axis); }
  [[nodiscard]] std::uint32_t fault_time(int group) const {
    return static_cast<std::uint32_t>(this->dut_.fault_time_cycles_o >> (32 * group));
  }

  static constexpr int kDebounce = 5;
  int debounce_ = kDebounce;
  std::array<Disc, kAxes> discs_;
  std::array<std::int64_t, kAxes> start_{};      // disc positions at which the counters had their reset value
  int noise_a_ = 0, noise_b_ = 0, noise_z_ = 0;  // inverted lines, one bit per axis
  std::uint8_t illegal_flags_ = 0, index_flags_ = 0;

 private:
  std::optional<SynchroniserJitter> jitter_;

  template <class Wide>
  static int half(const Wide& words, std::size_t index) {
    return static_cast<int>(words[index / 2] >> (16 * (index % 2)) & 0xFFFF);
  }
};

}  // namespace armature::test
