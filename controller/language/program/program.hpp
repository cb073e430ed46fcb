// A loaded program in some language, which is executed a line at a time.
#pragma once

#include <cstdint>

#include "controller/language/program/program_port.hpp"

namespace armature {

class Program {
 public:
  enum class Progress : std::uint8_t {
    kWorking,  // a line was executed, or a part of it; another step can be done at once
    kWaiting,  // for room, for the arm, for an input or for time; the same line continues with the next step
    kPaused,   // the program waits for the operator; its commands are over. The next step continues it
    kEnded,    // all lines are executed; the last commands may still be under way
    kAlarm,    // the program cannot continue; a note has said why
  };

  // What start() begins with: the first instruction at or behind this line. 0: the first one. False: there is no
  // instruction there, or this language begins with its first line only.
  [[nodiscard]] virtual bool select_line(std::uint32_t line) noexcept { return line == 0; }
  // True when the program has this line, so that it may pause there (ProgramPort::breakpoint_at()).
  [[nodiscard]] virtual bool has_line(ProgramPlace place) const noexcept = 0;
  // On: kPaused after each line, once the arm has executed it.
  virtual void set_single_step(bool on) noexcept = 0;

  // From the first line, or from that of select_line(). The program must be loaded.
  virtual void start() noexcept = 0;
  // Executes at most one line. A step is short. Not called after kEnded or kAlarm without a start().
  [[nodiscard]] virtual Progress step(ProgramPort& port) noexcept = 0;
  // True when the last step returned kWaiting for time or for an input: then step() must be called in each tick.
  [[nodiscard]] virtual bool waits_for_time() const noexcept = 0;

 protected:
  ~Program() = default;  // never owned through this interface
};

}  // namespace armature
