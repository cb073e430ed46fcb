// The variables of programs: global ones, and local ones of each call.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "controller/language/job/loader/operand_grammar.hpp"
#include "controller/language/job/memory/program_memory.hpp"
#include "controller/language/job/memory/words.hpp"
#include "controller/language/job/state/alarm.hpp"

namespace armature::job {

// A position as a variable holds it: the units of Position.
struct PositionValue {
  std::array<double, 6> value{};
  Frame frame = Frame::kPulse;
  std::uint8_t user = 0;
  std::uint8_t tool = 0;
  std::uint8_t rconf = 0;
  bool set = false;

  [[nodiscard]] static PositionValue of(const Position& position) noexcept {
    return {position.value, position.frame, position.user, position.tool, position.rconf, true};
  }
  [[nodiscard]] constexpr bool is_cartesian() const noexcept {
    return frame != Frame::kPulse && frame != Frame::kAngle;
  }
};

// A variable: type, number, and whether it belongs to the call.
struct VariableId {
  VariableType type = VariableType::kB;
  bool local = false;
  double number = 0.0;
};

class Variables {
 public:
  static constexpr std::size_t kLocalNumbers = 1'024;  // of all calls together
  static constexpr std::size_t kLocalPositions = 64;
  static constexpr std::size_t kMaxCalls = 16;

  // All 0, no position set, nothing returned, no call.
  void reset() noexcept;
  // Those that the headers of all jobs state.
  void set_positions(const ProgramMemory& memory) noexcept;

  // Gives a call its local variables, which are 0. kLocals: there is no room.
  [[nodiscard]] Alarm enter(const JobInfo& job) noexcept;
  void leave() noexcept;

  // Numbers. kIndex: there is no such variable. Storing cuts decimals off for B, I and D; kRange: the value does not
  // fit, and nothing is stored.
  [[nodiscard]] Alarm load(const VariableId& id, double& value) const noexcept;
  [[nodiscard]] Alarm store(const VariableId& id, double value) noexcept;
  // A position variable; null if there is none of this number.
  [[nodiscard]] PositionValue* position(const VariableId& id) noexcept;
  // $RV: the value of the last RET that had one.
  [[nodiscard]] double returned() const noexcept { return returned_; }
  void set_returned(double value) noexcept { returned_ = value; }

 private:
  static constexpr std::size_t kNumericTypes = 4;  // B, I, D, R
  struct Call {
    std::array<std::uint16_t, kNumericTypes> first{}, count{};
    std::uint16_t first_position = 0, positions = 0;
  };
  [[nodiscard]] const double* find(const VariableId& id) const noexcept;

  std::array<std::array<double, kVariablesOfType>, kNumericTypes> globals_{};
  std::array<PositionValue, kVariablesOfType> positions_{};
  std::array<double, kLocalNumbers> local_numbers_{};
  std::array<PositionValue, kLocalPositions> local_positions_{};
  std::array<Call, kMaxCalls + 1> calls_{};
  std::size_t depth_ = 0;
  double returned_ = 0.0;
};

}  // namespace armature::job
