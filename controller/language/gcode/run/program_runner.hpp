// Executes a G-code program on the arm.
//
// First it executes the program without the arm: errors of the text and places that the arm cannot reach are found
// before anything moves, with their line. Where the program reads an input, and after kMaxChecked lines, this check
// ends, as where it stops itself. Then the moves are sent ahead of the arm as long as the port has room; the dispatcher
// joins them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "controller/language/gcode/flow/canon_interpreter.hpp"
#include "controller/language/gcode/run/input_wait.hpp"
#include "controller/language/gcode/run/motion_commands.hpp"
#include "controller/language/gcode/run/motion_setup.hpp"
#include "controller/language/gcode/run/reach_check.hpp"
#include "controller/language/program/program.hpp"
#include "controller/language/program/program_port.hpp"

namespace armature::gcode {

class ProgramRunner final : public Program, private CanonSink {
 public:
  static constexpr std::int64_t kMaxChecked = 200'000;

  // `setup` must outlive the runner.
  explicit ProgramRunner(const MotionSetup& setup) noexcept
      : setup_(setup), interpreter_(*this), commands_(setup), check_(setup) {
    interpreter_.executor().tools().add(setup.settings.tools);
  }

  // The program must stay in memory. It begins with start(). A place is a line of its whole text.
  void load(const ProgramText& program) noexcept;

  // Program. A place is a line, from 1.
  [[nodiscard]] bool has_line(ProgramPlace place) const noexcept override { return place > 0 && place <= lines_; }
  [[nodiscard]] bool select_line(std::uint32_t line) noexcept override { return line <= 1; }
  void set_single_step(bool on) noexcept override;
  void start() noexcept override;
  [[nodiscard]] Progress step(ProgramPort& port) noexcept override;
  [[nodiscard]] bool waits_for_time() const noexcept override { return wait_.active(); }

 private:
  enum class Phase : std::uint8_t { kStart, kCheck, kRun };
  struct Queued {
    CanonCall call{};
    std::uint32_t line = 0;
  };

  void on_call(const CanonCall& call, std::uint32_t line) noexcept override;
  [[nodiscard]] Progress begin(ProgramPort& port) noexcept;
  void restart(Phase phase) noexcept;
  [[nodiscard]] Progress check_step(ProgramPort& port) noexcept;
  [[nodiscard]] Progress run_step(ProgramPort& port) noexcept;
  [[nodiscard]] bool pauses_here(ProgramPort& port) const noexcept;
  // These take the next call from the queue.
  [[nodiscard]] Progress execute_next(ProgramPort& port) noexcept;
  [[nodiscard]] Progress convert_next(ProgramPort& port) noexcept;
  [[nodiscard]] Progress wait_step(ProgramPort& port) noexcept;
  void note_line(ProgramPort& port, std::uint32_t line) noexcept;  // once when it begins
  void note_end(ProgramPort& port) noexcept;
  [[nodiscard]] Progress fail(ProgramPort& port) noexcept;  // with the error of the interpreter
  Progress alarm(ProgramPort& port, std::uint32_t line, std::string_view text) noexcept;

  const MotionSetup& setup_;
  CanonInterpreter interpreter_;
  MotionCommands commands_;
  ReachCheck check_;
  Executor::Stored stored_{};
  ProgramText program_{};
  std::uint32_t lines_ = 0;  // of it
  Phase phase_ = Phase::kStart;
  ProgramPort* port_ = nullptr;  // during a step
  Axes6 start_{};
  JointAngles start_joints_{};
  std::int64_t checked_ = 0;
  std::array<Queued, CanonInterpreter::kMaxCallsPerStep> queue_{};
  std::size_t queue_begin_ = 0;
  std::size_t queue_end_ = 0;
  std::size_t sent_ = 0;    // of the commands of the call
  std::uint32_t line_ = 0;  // of that call
  std::uint32_t noted_line_ = 0;
  bool paused_ = false;
  bool single_step_ = false;
  bool stepped_ = false;      // a line was executed since the last pause
  bool paused_here_ = false;  // before the next line: a breakpoint does not pause once more
  InputWait wait_{};
};

}  // namespace armature::gcode
