// The electronic gear of a drive: pulses to encoder counts by the exact ratio counts_per_rev / pulses_per_rev.
#pragma once

#include <cstdint>
#include <stdexcept>

namespace armature::cosim {

// A reference in counts that is never rounded: whole() + remainder() / pulses_per_rev.
class ElectronicGear {
 public:
  // Both at least 1.
  ElectronicGear(std::int32_t counts_per_rev, std::int32_t pulses_per_rev)
      : counts_per_rev_{counts_per_rev},
        pulses_per_rev_{pulses_per_rev},
        counts_per_pulse_{static_cast<double>(counts_per_rev) / static_cast<double>(pulses_per_rev)} {
    if (counts_per_rev < 1 || pulses_per_rev < 1) throw std::invalid_argument{"electronic gear: ratio is not positive"};
  }

  // Moves the reference by a number of pulses, signed by their direction. Any number of pulses in any order leaves no
  // error: the reference depends on their sum only.
  void pulses(std::int64_t count) {
    if (counts_per_rev_ == pulses_per_rev_) {
      whole_ += count;
      return;
    }
    remainder_ += count * counts_per_rev_;
    const std::int64_t turns = remainder_ / pulses_per_rev_ - (remainder_ % pulses_per_rev_ < 0 ? 1 : 0);
    whole_ += turns;
    set_remainder(remainder_ - turns * pulses_per_rev_);
  }
  // As it is after so many more pulses.
  [[nodiscard]] ElectronicGear after(std::int64_t count) const {
    ElectronicGear gear = *this;
    gear.pulses(count);
    return gear;
  }

  // Counts by which one pulse moves the reference.
  [[nodiscard]] double counts_per_pulse() const { return counts_per_pulse_; }

  // Sets the reference to a whole count.
  void set(std::int64_t counts) {
    whole_ = counts;
    set_remainder(0);
  }

  [[nodiscard]] std::int64_t whole() const { return whole_; }          // floor of the reference
  [[nodiscard]] std::int64_t remainder() const { return remainder_; }  // 0 .. pulses_per_rev - 1
  [[nodiscard]] double fraction() const { return fraction_; }          // 0 .. below 1

 private:
  void set_remainder(std::int64_t remainder) {
    remainder_ = remainder;
    fraction_ = static_cast<double>(remainder) / static_cast<double>(pulses_per_rev_);
  }

  std::int64_t counts_per_rev_;
  std::int64_t pulses_per_rev_;
  double counts_per_pulse_;
  std::int64_t whole_ = 0;
  std::int64_t remainder_ = 0;
  double fraction_ = 0.0;
};

}  // namespace armature::cosim
