// The operators and functions of expressions. Angles are in degrees.
#pragma once

#include <cstdint>
#include <string_view>

#include "controller/language/gcode/reader/error.hpp"

namespace armature::gcode {

// Two values are equal for EQ, and a value is whole, if they differ by no more.
inline constexpr double kEqual = 1e-4;

// A value or an error.
struct Outcome {
  double value = 0.0;
  ErrorCode error{};
  bool ok = true;
};

enum class Operator : std::uint8_t {
  kPower,
  kTimes,
  kDivide,
  kMod,
  kPlus,
  kMinus,
  kEq,
  kNe,
  kGt,
  kGe,
  kLt,
  kLe,
  kAnd,
  kOr,
  kXor,
};
struct OperatorWord {
  std::string_view text;
  Operator op;
  int precedence;  // a higher one binds first; equal ones from left to right
};
inline constexpr int kLowestPrecedence = 1;
inline constexpr int kHighestPrecedence = 5;

// The operator at the start of a text in lower case; null: none.
[[nodiscard]] const OperatorWord* find_operator(std::string_view text) noexcept;
[[nodiscard]] Outcome apply(Operator op, double a, double b) noexcept;

// A function of one value.
struct Function {
  std::string_view name;
  Outcome (*apply)(double);
};
[[nodiscard]] const Function* find_function(std::string_view text) noexcept;
[[nodiscard]] double arc_tangent_deg(double y, double x) noexcept;

// The nearest whole number, halves away from zero; also beyond the integers.
[[nodiscard]] double rounded(double x) noexcept;

}  // namespace armature::gcode
