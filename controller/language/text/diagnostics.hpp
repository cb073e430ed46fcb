// What a loader says about a program text: each error and warning with its place.
#pragma once

#include <cstdint>
#include <string_view>

#include "controller/language/text/fixed_text.hpp"

namespace armature {

using DiagnosticText = FixedText<160>;

struct Diagnostic {
  enum class Severity : std::uint8_t { kError, kWarning };
  Severity severity = Severity::kError;
  std::string_view file{};
  std::uint32_t line = 0;    // from 1; 0: the whole file
  std::uint32_t column = 0;  // from 1
  DiagnosticText text{};
};

class Diagnostics {
 public:
  virtual void report(const Diagnostic& diagnostic) noexcept = 0;

 protected:
  ~Diagnostics() = default;  // never owned through this interface
};

}  // namespace armature
