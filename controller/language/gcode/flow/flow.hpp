// The course of a program from line to line: subroutines, conditions and loops.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/language/gcode/execute/executor.hpp"
#include "controller/language/gcode/flow/flow_index.hpp"
#include "controller/language/gcode/flow/o_word_values.hpp"
#include "controller/language/gcode/reader/source_line.hpp"

namespace armature::gcode {

class Flow {
 public:
  explicit Flow(Executor& executor) noexcept : executor_(executor) {}

  // Starts at the first line of a program, whose O-words it reads. `line` is scratch.
  [[nodiscard]] Failure begin(const ProgramText& program, SourceLine& line) noexcept;

  // The next line: where it begins, and its number, from 1.
  [[nodiscard]] std::size_t next() const noexcept { return next_; }
  [[nodiscard]] std::uint32_t next_line() const noexcept { return passed_ + 1; }
  // Whether it belongs to a subroutine or a subprogram.
  [[nodiscard]] bool in_call() const noexcept { return frame_count_ > 0; }
  [[nodiscard]] const FlowIndex& index() const noexcept { return index_; }

  // Continues behind the next line.
  void pass(const LineSpan& line) noexcept;
  // Executes the O-word of the passed line if its values do not matter: it is a branch behind one that was executed, or
  // the definition of a subroutine. False: it is another one.
  [[nodiscard]] bool skip(const OWord& word) noexcept;
  // Executes another one. M99 must be in a call.
  [[nodiscard]] Failure execute(const OWord& word, const OWordValues& values) noexcept;

 private:
  static constexpr std::size_t kMaxRepeats = 64;
  struct Frame {
    std::size_t return_to = 0;
    std::uint32_t return_line = 0;
    std::size_t repeats = 0;         // of the callers
    const OWord* program = nullptr;  // that M98 has called; null: CALL has called a subroutine
    std::int32_t left = 0;           // of its turns, with the present one
  };
  struct Repeat {
    std::uint16_t index = 0;
    std::int32_t left = 0;
  };

  void go_to(const OWord& word) noexcept;
  void go_behind(const OWord& word) noexcept;
  void skip_branch(const OWord& next) noexcept;
  [[nodiscard]] Failure begin_repeat(const OWord& word, double times) noexcept;
  void end_repeat(const OWord& start) noexcept;
  void drop_repeats(std::uint16_t first) noexcept;
  [[nodiscard]] Failure call_subroutine(const OWordValues& values) noexcept;
  [[nodiscard]] Failure call_program(const OWordValues& values) noexcept;
  void return_from_subroutine(const OWordValues& values) noexcept;
  [[nodiscard]] Failure return_from_program() noexcept;
  void enter_frame(const OWord& first, Frame frame) noexcept;
  void leave_frame() noexcept;

  Executor& executor_;
  FlowIndex index_{};
  std::size_t next_ = 0;
  std::uint32_t passed_ = 0;  // lines before it
  bool choosing_ = false;     // a condition was false: the next branch is examined
  std::array<Frame, Parameters::kMaxCalls> frames_{};
  std::size_t frame_count_ = 0;
  std::array<Repeat, kMaxRepeats> repeats_{};
  std::size_t repeat_count_ = 0;
};

}  // namespace armature::gcode
