// Executes a G-code program line by line, as canonical calls.
//
// The program is text in memory that must stay while it runs. Each step() makes at most kMaxCallsPerStep canonical
// calls, so a sink with so much room never overflows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "controller/language/gcode/canon/canon.hpp"
#include "controller/language/gcode/execute/executor.hpp"
#include "controller/language/gcode/flow/flow.hpp"
#include "controller/language/gcode/reader/source_line.hpp"
#include "controller/language/gcode/reader/value_reader.hpp"

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
  // The line that the next step begins; 0: it continues a drilling cycle.
  [[nodiscard]] std::uint32_t next_line() const noexcept { return executor_.in_cycle() ? 0 : flow_.next_line(); }
  [[nodiscard]] const Error& error() const noexcept { return error_; }  // kFailed
  // kEnded: the program has come to the end of its text, without M2, M30 or a second '%'. It ends as with M2.
  [[nodiscard]] bool ended_without_code() const noexcept { return ended_without_code_; }
  static constexpr std::string_view kNoEndCode = "the program ends without M2, M30 or a second '%'";
  // For presets before begin(): globals, tools.
  [[nodiscard]] Executor& executor() noexcept { return executor_; }

 private:
  State fail(Error error) noexcept;
  [[nodiscard]] State execute_o_word(const OWord& word) noexcept;
  [[nodiscard]] State execute_words() noexcept;
  [[nodiscard]] State end_of_file() noexcept;
  [[nodiscard]] State end_program() noexcept;
  [[nodiscard]] ValueReader line_reader() noexcept;
  [[nodiscard]] bool assign(const Assignments& assignments) noexcept;
  // False if the comment stops the program.
  [[nodiscard]] bool say_comment() noexcept;
  void after_block() noexcept;

  Executor executor_;
  Flow flow_{executor_};
  SourceLine source_{};
  ProgramText program_{};
  Options options_{};
  std::uint32_t line_ = 0;  // of the last step
  bool percent_ = false;    // the program begins with '%'
  State state_ = State::kEnded;
  Error error_{};
  bool ended_without_code_ = false;
};

}  // namespace armature::gcode
