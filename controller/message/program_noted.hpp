// What a program reports while core 1 executes it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "controller/base/members.hpp"
#include "controller/base/misfit.hpp"

namespace armature {

struct ProgramNoted {
  enum class Kind : std::uint8_t {
    kLine,     // the program begins to execute this line; the arm may be some lines behind
    kMessage,  // an instruction shows a text to the operator
    kAlarm,    // the program cannot continue; the text says why
    kStopped,  // the program has failed: the arm did not carry out a command of this line, or not to its end
    kPaused,   // the program waits for the operator behind this line
    kHeld,     // the operator has held it; the arm brakes on the path of this line
    kResumed,  // the operator lets it continue
    kAborted,  // the operator has ended it, and the arm stands
    kEnded,    // all lines are executed, and the arm stands at the end of the last one
    kWaits,    // a line begins to wait for `inputs`, or for another condition
    kWaited,   // its wait is over, perhaps at once: the condition holds; or the text says why else
    kOver,     // after kAlarm or kStopped: what the program had sent is over, too
  };
  static constexpr std::size_t kMaxText = 64;

  std::uint32_t place = 0;  // in the program, as its language defines it
  Kind kind = Kind::kLine;
  std::uint8_t text_size = 0;
  std::uint16_t inputs = 0;  // kWaits, kWaited: the inputs of the tool that the condition has read, bit 0 for pin 1
  std::array<char, kMaxText> text{};

  [[nodiscard]] constexpr const void* misfit() const noexcept {
    return first_misfit({{&text_size, text_size <= kMaxText}});
  }
  [[nodiscard]] constexpr std::string_view view() const noexcept { return {text.data(), text_size}; }
  // What does not fit is cut off.
  constexpr void set_text(std::string_view all) noexcept {
    text_size = static_cast<std::uint8_t>(all.size() < kMaxText ? all.size() : kMaxText);
    for (std::size_t i = 0; i < text_size; ++i) text[i] = all[i];
  }
  ARMATURE_MEMBERS(ProgramNoted, place, kind, text_size, inputs, text)
};

}  // namespace armature
