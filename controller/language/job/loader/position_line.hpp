// Reads the line of a position above the instructions, for example C00003=0,0,90000,0,0,0.
#pragma once

#include <cstddef>
#include <string_view>

#include "controller/language/job/loader/line_lexer.hpp"
#include "controller/language/job/memory/program_memory.hpp"

namespace armature::job {

[[nodiscard]] constexpr bool holds_joints(Frame frame) noexcept {
  return frame == Frame::kPulse || frame == Frame::kAngle;
}

class PositionLine {
 public:
  // `modal`: what the lines above say about the position.
  PositionLine(std::string_view line, const Position& modal) noexcept : line_{line}, position_{modal} {}

  [[nodiscard]] bool read() noexcept;
  // After read(): the position, without its line; or else what is wrong.
  [[nodiscard]] const Position& position() const noexcept { return position_; }
  [[nodiscard]] const LexProblem& problem() const noexcept { return problem_; }

 private:
  [[nodiscard]] bool read_name() noexcept;
  [[nodiscard]] bool read_values() noexcept;
  [[nodiscard]] bool read_value() noexcept;
  [[nodiscard]] bool read_end() noexcept;
  [[nodiscard]] bool fail(std::size_t at, const DiagnosticText& text) noexcept;
  [[nodiscard]] bool is_here(char character) const noexcept { return at_ < line_.size() && line_[at_] == character; }

  std::string_view line_;
  std::size_t at_ = 0;
  Position position_;
  LexProblem problem_{};
};

}  // namespace armature::job
