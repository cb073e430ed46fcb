// The time that a core needs for its instructions, at a stated number of clocks for each of them.
#pragma once

#include <cmath>
#include <cstdint>

#include "controller/base/units.hpp"

namespace armature::cosim::iss {

class InstructionTime {
 public:
  // `cpi`: clocks of the core for each instruction, kept in thousandths.
  explicit InstructionTime(double cpi) : milli_cpi_{std::llround(cpi * 1000)} {}

  void count(std::uint32_t instructions) { instructions_ += instructions; }
  [[nodiscard]] std::int64_t instructions() const { return instructions_; }
  // Begins again: nothing is counted, nothing is due.
  void reset() { instructions_ = taken_ = 0; }

  // The whole cycles of the logic that all instructions so far need and that were not taken before. The rest of a cycle
  // counts for the next ones.
  [[nodiscard]] Cycles take() {
    const Cycles taken = due();
    taken_ += taken.value();
    return taken;
  }
  // What is left of a cycle that take() has not returned, in parts of a cycle.
  [[nodiscard]] std::int64_t rest() const { return instructions_ * milli_cpi_ * kLogicClocks % (1000 * kCoreClocks); }
  // What take() returns.
  [[nodiscard]] Cycles due() const {
    return Cycles{instructions_ * milli_cpi_ * kLogicClocks / (1000 * kCoreClocks) - taken_};
  }

 private:
  // 50 MHz and 666.667 MHz.
  static constexpr std::int64_t kLogicClocks = 3;
  static constexpr std::int64_t kCoreClocks = 40;

  std::int64_t milli_cpi_;
  std::int64_t instructions_ = 0;
  std::int64_t taken_ = 0;
};

}  // namespace armature::cosim::iss
