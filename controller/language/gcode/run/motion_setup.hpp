// How a G-code program is placed in the cell, and what its motions and codes mean for the arm.
#pragma once

#include <array>
#include <cstdint>
#include <numbers>

#include "controller/base/members.hpp"
#include "controller/base/misfit.hpp"
#include "controller/cell/robot_cell.hpp"
#include "controller/language/gcode/canon/offsets.hpp"
#include "controller/message/command.hpp"

namespace armature::gcode {

inline constexpr std::uint8_t kToolPins = 16;

// An analog output of a program is a binary number on successive pins of the tool.
struct AnalogPins {
  std::uint8_t first_pin = 0;  // 1..16, the lowest bit; 0: the output does not exist
  std::uint8_t bits = 0;
  double full = 1.0;  // the value at which all bits are on

  [[nodiscard]] constexpr const void* misfit() const noexcept {
    return first_misfit({{&first_pin, first_pin <= kToolPins},
                         {&bits, first_pin == 0 || (bits >= 1 && first_pin + bits - 1 <= kToolPins)},
                         {&full, is_positive(full)}});
  }
  ARMATURE_MEMBERS(AnalogPins, first_pin, bits, full)
};

// The settings of a user: [gcode] of a scenario.
struct MotionSettings {
  enum class Orientation : std::uint8_t {
    kKept,     // as at the start of the program; A, B and C must stay 0
    kNormal,   // the tool points against Z of the frame; A, B and C turn it about the fixed X, then Y, then Z
    kTangent,  // turns with the path; A, B and C must stay 0
  };

  FrameId frame = kBaseFrame;  // the coordinates of the machine are those of this frame
  Orientation orientation = Orientation::kKept;

  double rapid_mm_s = 250.0;  // of G0
  double rapid_turn_rad_s = std::numbers::pi;
  double accel_mm_s2 = 2'000.0;
  double turn_accel_rad_s2 = 20.0;
  double corner_mm = 0.5;  // the corners of G64 without P: the speed matters more than the corner

  std::array<AnalogPins, 4> analog{};  // of M67 and M68, by E
  std::uint8_t spindle_pin = 0;        // on with M3 and M4; 0: none
  std::uint8_t mist_pin = 0;
  std::uint8_t flood_pin = 0;

  ToolNumbers tools{};  // those that T may select

  [[nodiscard]] constexpr const void* misfit() const noexcept {
    return first_misfit({{&frame, frame.index <= kUserFrames},
                         {&rapid_mm_s, is_positive(rapid_mm_s)},
                         {&rapid_turn_rad_s, is_positive(rapid_turn_rad_s)},
                         {&accel_mm_s2, is_positive(accel_mm_s2)},
                         {&turn_accel_rad_s2, is_positive(turn_accel_rad_s2)},
                         {&corner_mm, is_at_least_0(corner_mm)},
                         {&spindle_pin, spindle_pin <= kToolPins},
                         {&mist_pin, mist_pin <= kToolPins},
                         {&flood_pin, flood_pin <= kToolPins}});
  }
  ARMATURE_MEMBERS(MotionSettings, frame, orientation, rapid_mm_s, rapid_turn_rad_s, accel_mm_s2, turn_accel_rad_s2,
                   corner_mm, analog, spindle_pin, mist_pin, flood_pin, tools)
};

struct MotionSetup {
  RobotCell cell;
  MotionSettings settings{};
};

}  // namespace armature::gcode
