#include "controller/core/math.hpp"

#include <cmath>

namespace armature::math {

double sin(double x) noexcept {
  return std::sin(x);
}
double cos(double x) noexcept {
  return std::cos(x);
}
SinCos sin_cos(double x) noexcept {
  return {std::sin(x), std::cos(x)};
}
double atan2(double y, double x) noexcept {
  return std::atan2(y, x);
}
double hypot(double x, double y) noexcept {
  return std::hypot(x, y);
}

}  // namespace armature::math
