// The inputs and outputs that a program can name: those of the arm, and outputs beyond, which have a level and no pin.
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>

#include "controller/language/job/memory/words.hpp"
#include "controller/language/program/program_port.hpp"

namespace armature::job {

// How many pins an input or output stands for; 0: none that exists here.
[[nodiscard]] constexpr std::size_t pins_of(IoType type) noexcept {
  switch (type) {
    case IoType::kInput:
    case IoType::kOutput:
      return 1;
    case IoType::kInputHalfGroup:
    case IoType::kOutputHalfGroup:
      return 4;
    case IoType::kInputGroup:
    case IoType::kOutputGroup:
      return 8;
    default:
      return 0;
  }
}
[[nodiscard]] constexpr bool is_output(IoType type) noexcept {
  return type == IoType::kOutput || type == IoType::kOutputGroup || type == IoType::kOutputHalfGroup;
}

class PinLevels {
 public:
  static constexpr std::size_t kPins = 16;  // inputs and outputs of the arm
  static constexpr std::size_t kMaxOutputs = 4'096;

  void reset() noexcept { levels_.reset(); }
  // Of an output beyond kPins.
  void set(std::size_t pin, bool level) noexcept { levels_[pin] = level; }
  [[nodiscard]] bool level(std::size_t pin, bool output, ProgramPort& port) const noexcept {
    return pin > kPins ? levels_[pin] : port.level(static_cast<std::uint8_t>(pin), output);
  }

 private:
  std::bitset<kMaxOutputs + 1> levels_{};
};

}  // namespace armature::job
