// Executes a G-code program line by line, as canonical calls.
//
// The program is text in memory that must stay while it runs. Each step() makes at most kMaxCallsPerStep canonical
// calls, so a sink with so much room never overflows.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "controller/language/gcode/canon.hpp"
#include "controller/language/gcode/executor.hpp"
#include "controller/language/gcode/flow_index.hpp"
#include "controller/language/gcode/source_line.hpp"

namespace armature::gcode {

struct Options {
  bool block_delete = false;  // skip lines that begin with '/'
  Axes6 start{};              // where the tool is, in coordinates of the machine
};

class CanonInterpreter {
 public:
  enum class State : std::uint8_t {
    kRunning,
    kStopped,        // M0, M1, M60; resume() continues
    kWaitsForInput,  // M66; give_input() continues
    kEnded,
    kFailed,
  };
  static constexpr std::size_t kMaxCallsPerStep = 64;

  explicit CanonInterpreter(CanonSink& sink) noexcept : executor_(sink) {}

  // Reads the O-words of a program and begins it: kRunning or kFailed.
  State begin(const ProgramText& program, const Options& options) noexcept;
  // Executes a line, or a part of a drilling cycle. No effect unless kRunning.
  State step() noexcept;
  void resume() noexcept;
  void give_input(double value) noexcept;

  [[nodiscard]] State state() const noexcept { return state_; }
  // The line of the last step, from 1.
  [[nodiscard]] std::uint32_t line() const noexcept { return line_; }
  // The line that the next step begins; 0: it goes on with a drilling cycle.
  [[nodiscard]] std::uint32_t next_line() const noexcept { return executor_.in_cycle() ? 0 : passed_ + 1; }
  [[nodiscard]] const Error& error() const noexcept { return error_; }  // kFailed
  // kEnded: the program has come to the end of its text, without M2, M30 or a second '%'. It ends as with M2.
  [[nodiscard]] bool ended_without_code() const noexcept { return ended_without_code_; }
  static constexpr std::string_view kNoEndCode = "the program ends without M2, M30 or a second '%'";
  // For presets before begin(): globals, tools.
  [[nodiscard]] Executor& executor() noexcept { return executor_; }

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

  State fail(Error error) noexcept;
  State fail(const ValueReader& reader) noexcept { return fail(*reader.error()); }
  void go_to(const OWord& word, bool behind) noexcept;
  [[nodiscard]] State execute_words(std::size_t head) noexcept;
  [[nodiscard]] State end_of_file() noexcept;
  [[nodiscard]] bool assign(const Assignments& assignments) noexcept;
  // False if the comment stops the program.
  [[nodiscard]] bool say_comment() noexcept;
  void after_block() noexcept;
  // canon_flow.cpp
  [[nodiscard]] State execute_o_word(const OWord& word, std::size_t head) noexcept;
  [[nodiscard]] bool read_arguments(const OWord& word, ValueReader& reader) noexcept;
  void run_branch(const OWord& word) noexcept;
  void run_loop(const OWord& word) noexcept;
  [[nodiscard]] State execute_call_code(ValueReader& reader) noexcept;
  [[nodiscard]] State execute_return_code() noexcept;
  [[nodiscard]] std::optional<std::uint16_t> computed_name(ValueReader& reader) noexcept;
  [[nodiscard]] bool run_call(std::optional<std::uint16_t> name) noexcept;
  void run_return() noexcept;
  void enter_frame(const OWord& begin, Frame frame) noexcept;
  void leave_frame() noexcept;
  void drop_repeats(std::uint16_t first) noexcept;

  Executor executor_;
  FlowIndex index_{};
  SourceLine source_{};
  ProgramText program_{};
  Options options_{};
  std::size_t at_ = 0;        // begin of the next line
  std::uint32_t line_ = 0;    // of the last step
  std::uint32_t passed_ = 0;  // lines before at_
  bool percent_ = false;      // the program begins with '%'
  bool choosing_ = false;     // a condition was false: the next branch is examined
  State state_ = State::kEnded;
  Error error_{};
  bool ended_without_code_ = false;
  std::array<Frame, Parameters::kMaxCalls> frames_{};
  std::size_t frame_count_ = 0;
  std::array<Repeat, kMaxRepeats> repeats_{};
  std::size_t repeat_count_ = 0;
  // Values of the O-word that is executed.
  std::array<double, Parameters::kLocals> arguments_{};
  std::size_t argument_count_ = 0;
};

}  // namespace armature::gcode
