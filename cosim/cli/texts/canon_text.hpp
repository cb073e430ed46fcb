// Canonical calls of a G-code program as text, in the format of the stand-alone interpreter `rs274` of LinuxCNC.
#pragma once

#include <string>

#include "controller/language/gcode/canon/canon.hpp"

namespace armature::cosim {

// Appends a line for each call. Lengths are printed in the units that the program uses at the time.
class CanonText final : public gcode::CanonSink {
 public:
  void on_call(const gcode::CanonCall& call, std::uint32_t line) noexcept override;
  [[nodiscard]] const std::string& text() const noexcept { return text_; }
  void clear() noexcept { text_.clear(); }

 private:
  std::string text_;
  int number_ = 0;
  double unit_mm_ = 1.0;
};

}  // namespace armature::cosim
