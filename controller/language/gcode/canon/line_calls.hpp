// The canonical calls of the line that is executed.
#pragma once

#include <cstdint>

#include "controller/language/gcode/canon/canon.hpp"

namespace armature::gcode {

class LineCalls {
 public:
  explicit LineCalls(CanonSink& sink) noexcept : sink_(sink) {}

  void begin_line(std::uint32_t line) noexcept { line_ = line; }
  [[nodiscard]] std::uint32_t line() const noexcept { return line_; }
  void emit(const CanonCall& call) noexcept { sink_.on_call(call, line_); }

 private:
  CanonSink& sink_;
  std::uint32_t line_ = 0;
};

}  // namespace armature::gcode
