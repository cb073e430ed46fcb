#include "cosim/plot/axis_scale.hpp"

#include <algorithm>
#include <cmath>

#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

// Multiplied or divided step by step, so that no library decides about the last bit.
double power_of_ten(int exponent) {
  double power = 1;
  for (int i = 0; i < std::abs(exponent); ++i) power *= 10;
  return exponent < 0 ? 1 / power : power;
}

// A multiple of a decimal step is often a little beside the number that is meant.
constexpr double kHair = 1e-9;

}  // namespace

std::vector<double> AxisScale::marks() const {
  std::vector<double> marks;
  const double first = std::ceil(low / step - kHair);
  const double last = std::floor(high / step + kHair);
  for (double i = first; i <= last; ++i) marks.push_back(i * step);
  return marks;
}

std::string AxisScale::text(double mark) const {
  std::string text = fixed_text(std::fabs(mark), digits);
  return mark < -step / 2 ? "\u2212" + text : text;
}

AxisScale exact_scale(double low, double high, int most_marks) {
  constexpr double kLeastRange = 1e-6;
  constexpr int kSmallest = -8;
  constexpr int kLargest = 12;
  AxisScale scale{.low = low, .high = std::max(high, low + kLeastRange)};
  for (int exponent = kSmallest; exponent < kLargest; ++exponent) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      scale.step = factor * power_of_ten(exponent);
      scale.digits = std::max(0, -exponent);
      if ((scale.high - scale.low) / scale.step <= most_marks) return scale;
    }
  }
  return scale;
}

AxisScale round_scale(double low, double high, int most_marks) {
  AxisScale scale = exact_scale(low, high, most_marks);
  scale.low = std::floor(scale.low / scale.step + kHair) * scale.step;
  scale.high = std::ceil(scale.high / scale.step - kHair) * scale.step;
  return scale;
}

}  // namespace armature::cosim
