#include "controller/language/gcode/reader/operations.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "controller/base/angle_units.hpp"
#include "controller/base/math.hpp"
#include "controller/base/rounding.hpp"
#include "controller/language/gcode/reader/elementary.hpp"

namespace armature::gcode {
namespace {

constexpr std::array kOperators{OperatorWord{"**", Operator::kPower, 5}, OperatorWord{"*", Operator::kTimes, 4},
                                OperatorWord{"/", Operator::kDivide, 4}, OperatorWord{"mod", Operator::kMod, 4},
                                OperatorWord{"+", Operator::kPlus, 3},   OperatorWord{"-", Operator::kMinus, 3},
                                OperatorWord{"eq", Operator::kEq, 2},    OperatorWord{"ne", Operator::kNe, 2},
                                OperatorWord{"gt", Operator::kGt, 2},    OperatorWord{"ge", Operator::kGe, 2},
                                OperatorWord{"lt", Operator::kLt, 2},    OperatorWord{"le", Operator::kLe, 2},
                                OperatorWord{"and", Operator::kAnd, 1},  OperatorWord{"or", Operator::kOr, 1},
                                OperatorWord{"xor", Operator::kXor, 1}};

constexpr Outcome failed(ErrorCode error) noexcept {
  return {.error = error, .ok = false};
}
Outcome truth(bool value) noexcept {
  return {.value = value ? 1.0 : 0.0};
}

// Between 0 and |divisor|.
double floored_remainder(double a, double divisor) noexcept {
  const double size = std::fabs(divisor);
  const double rest = a - std::floor(a / size) * size;
  return rest >= size ? 0.0 : rest;
}

Outcome of_angle(double deg, double (*function)(double)) noexcept {
  return {.value = function(direction_rad(deg))};
}
double tangent(double x) noexcept {
  const math::SinCos at = math::sin_cos(x);
  return at.sin / at.cos;
}
// sqrt(1 - x^2) without loss near 1.
double other_leg(double x) noexcept {
  return std::sqrt((1.0 - x) * (1.0 + x));
}
Outcome arc_sine(double x) noexcept {
  if (std::fabs(x) > 1.0) return failed(ErrorCode::kOutsideDomain);
  return {.value = math::atan2(x, other_leg(x)) / kRadPerDeg};
}
Outcome arc_cosine(double x) noexcept {
  if (std::fabs(x) > 1.0) return failed(ErrorCode::kOutsideDomain);
  return {.value = math::atan2(other_leg(x), x) / kRadPerDeg};
}
constexpr std::array kFunctions{
    Function{"abs", [](double x) noexcept { return Outcome{.value = std::fabs(x)}; }},
    Function{"acos", arc_cosine},
    Function{"asin", arc_sine},
    Function{"cos", [](double x) noexcept { return of_angle(x, [](double a) { return math::cos(a); }); }},
    Function{"exp", [](double x) noexcept { return Outcome{.value = exponential(x)}; }},
    Function{"fix", [](double x) noexcept { return Outcome{.value = std::floor(x)}; }},
    Function{"fup", [](double x) noexcept { return Outcome{.value = rounded_up(x)}; }},
    Function{
        "ln",
        [](double x) noexcept { return x > 0.0 ? Outcome{.value = logarithm(x)} : failed(ErrorCode::kOutsideDomain); }},
    Function{"round", [](double x) noexcept { return Outcome{.value = rounded(x)}; }},
    Function{"sin", [](double x) noexcept { return of_angle(x, [](double a) { return math::sin(a); }); }},
    Function{"sqrt",
             [](double x) noexcept {
               return x >= 0.0 ? Outcome{.value = std::sqrt(x)} : failed(ErrorCode::kOutsideDomain);
             }},
    Function{"tan", [](double x) noexcept { return of_angle(x, tangent); }}};

}  // namespace

const OperatorWord* find_operator(std::string_view text) noexcept {
  const auto* const found =
      std::ranges::find_if(kOperators, [text](const OperatorWord& word) { return text.starts_with(word.text); });
  return found == kOperators.end() ? nullptr : found;
}

const Function* find_function(std::string_view text) noexcept {
  const auto* const found =
      std::ranges::find_if(kFunctions, [text](const Function& one) { return text.starts_with(one.name); });
  return found == kFunctions.end() ? nullptr : found;
}

Outcome apply(Operator op, double a, double b) noexcept {
  switch (op) {
    case Operator::kPower:
      if (a < 0.0 && std::floor(b) != b) return failed(ErrorCode::kOutsideDomain);
      return {.value = power(a, b)};
    case Operator::kTimes:
      return {.value = a * b};
    case Operator::kDivide:
      return b == 0.0 ? failed(ErrorCode::kDivisionByZero) : Outcome{.value = a / b};
    case Operator::kMod:
      return b == 0.0 ? failed(ErrorCode::kDivisionByZero) : Outcome{.value = floored_remainder(a, b)};
    case Operator::kPlus:
      return {.value = a + b};
    case Operator::kMinus:
      return {.value = a - b};
    case Operator::kEq:
      return truth(std::fabs(a - b) < kEqual);
    case Operator::kNe:
      return truth(!(std::fabs(a - b) < kEqual));
    case Operator::kGt:
      return truth(a > b);
    case Operator::kGe:
      return truth(a >= b);
    case Operator::kLt:
      return truth(a < b);
    case Operator::kLe:
      return truth(a <= b);
    case Operator::kAnd:
      return truth(a != 0.0 && b != 0.0);
    case Operator::kOr:
      return truth(a != 0.0 || b != 0.0);
    case Operator::kXor:
      return truth((a != 0.0) != (b != 0.0));
  }
  return {};
}

double arc_tangent_deg(double y, double x) noexcept {
  return math::atan2(y, x) / kRadPerDeg;
}

double rounded(double x) noexcept {
  const double magnitude = std::floor(std::fabs(x) + 0.5);
  return x < 0.0 ? -magnitude : magnitude;
}

}  // namespace armature::gcode
