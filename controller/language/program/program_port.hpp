// The surroundings of a program that is executed: the arm, the pins, the time and the operator.
#pragma once

#include <cstdint>
#include <string_view>

#include "controller/base/units.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/language/text/fixed_text.hpp"
#include "controller/message/command.hpp"
#include "controller/message/program_noted.hpp"

namespace armature {

// Where in the program a command or a note comes from: 24 bits that the program defines, see its place_of().
using ProgramPlace = std::uint32_t;

// What a program tells the operator.
struct ProgramNote {
  using Kind = ProgramNoted::Kind;  // a program gives kLine, kMessage, kAlarm, kWaits and kWaited
  Kind kind = Kind::kLine;
  ProgramPlace place = 0;
  FixedText<ProgramNoted::kMaxText> text{};
};

// The text of kWaited when the condition did not come true in its time.
inline constexpr std::string_view kWaitTimeOver = "its time is over";

class ProgramPort {
 public:
  // True while one more command can be sent.
  [[nodiscard]] virtual bool has_room() const noexcept = 0;
  // Sends a command with has_room(); commands are executed in this order. The port sets its tag from `place`. Allowed:
  // JointMove, PoseMove, CartesianMove, Dwell, SetOutput and WaitInput.
  virtual void send(const Command& command, ProgramPlace place) noexcept = 0;
  // Brakes within the limits of the move, and drops what was sent; the program continues. False: there is no room for
  // this order, try it again.
  [[nodiscard]] virtual bool stop() noexcept = 0;
  // True when all commands that were sent are over and the arm stands.
  [[nodiscard]] virtual bool done() const noexcept = 0;
  // Where the arm stands; only when done().
  [[nodiscard]] virtual JointAngles joints() const noexcept = 0;
  // The level of a pin of the tool, 1..16; `output`: that of an output as it was set.
  [[nodiscard]] virtual bool level(std::uint8_t pin, bool output) noexcept = 0;
  // Switches an output on at once, not in sequence, and off after `duration`, whatever becomes of the program. A second
  // pulse of the pin begins again. Not in a program that sends moves with outputs, which core 0 writes.
  virtual void pulse(std::uint8_t pin, Ticks duration) noexcept = 0;
  [[nodiscard]] virtual Ticks now() noexcept = 0;
  virtual void note(const ProgramNote& note) noexcept = 0;
  // The program comes to this line. True: it pauses before it executes the line, as soon as done().
  [[nodiscard]] virtual bool breakpoint_at(ProgramPlace place) noexcept = 0;
  // The step has computed so many inverse kinematics. They take the time of the core.
  virtual void charge_inverses(std::int64_t count) noexcept = 0;

 protected:
  ~ProgramPort() = default;  // never owned through this interface
};

}  // namespace armature
