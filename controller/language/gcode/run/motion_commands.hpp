// Converts canonical calls to commands of the arm.
//
// Outputs that a program switches with the next motion become outputs at the start of that move. Only four fit;
// further ones are switched before it, with a stop.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "controller/language/gcode/canon/canon.hpp"
#include "controller/language/gcode/canon/offsets.hpp"
#include "controller/language/gcode/run/motion_setup.hpp"
#include "controller/message/command.hpp"

namespace armature::gcode {

// What the arm cannot do.
enum class MotionProblem : std::uint8_t { kNoSuchOutput, kNoSuchAnalogOutput, kDwellTooLong, kTurnNotAllowed };
[[nodiscard]] std::string_view text_of(MotionProblem problem) noexcept;

class MotionCommands {
 public:
  static constexpr std::size_t kMaxCommands = 20;  // of one call: all pins, an arc and a line
  static constexpr int kPins = kToolPins;

  explicit MotionCommands(const MotionSetup& setup) noexcept : setup_(setup) {}

  // The tool is at `machine`, in coordinates of the machine.
  void begin(const Axes6& machine) noexcept;

  // Makes the commands of a call, in place of those before. Calls that have no command make none.
  [[nodiscard]] std::optional<MotionProblem> convert(const CanonCall& call) noexcept;
  [[nodiscard]] std::span<const Command> commands() const noexcept { return {commands_.data(), count_}; }

 private:
  using Problem = std::optional<MotionProblem>;

  void add(const Command& command) noexcept { commands_[count_++] = command; }
  void set_pin(std::uint8_t pin, bool on) noexcept;
  [[nodiscard]] Problem set_digital(const SetDigitalOutput& call) noexcept;
  [[nodiscard]] Problem set_analog(const SetAnalogOutput& call) noexcept;
  [[nodiscard]] Problem dwell(double seconds) noexcept;
  [[nodiscard]] Problem line(const Axes6& place, bool rapid) noexcept;
  [[nodiscard]] Problem arc(const ArcFeed& call) noexcept;
  void add_line(const Axes6& machine, bool rapid) noexcept;
  [[nodiscard]] CartesianMove move_to(const Axes6& machine, bool rapid) const noexcept;
  void add_move(CartesianMove move) noexcept;

  const MotionSetup& setup_;
  Offsets offsets_{};
  Axes6 machine_{};  // where the tool is
  Plane plane_ = Plane::kXy;
  SetMotionControlMode control_{};
  double feed_mm_s_ = 0.0;
  double feed_deg_s_ = 0.0;         // of motions of only A, B and C
  std::uint32_t pending_mask_ = 0;  // pins that change with the next motion: bit i for pin i + 1
  std::uint32_t pending_levels_ = 0;
  std::array<Command, kMaxCommands> commands_{};
  std::size_t count_ = 0;
};

}  // namespace armature::gcode
