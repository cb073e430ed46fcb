#include "cosim/campaign/draw.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace armature::cosim {

double Draw::decades(double low, double high) {
  std::vector<double> begins{low};
  double power = 1e-9;
  while (power <= low) power *= 10;
  for (; power < high; power *= 10) begins.push_back(power);
  const auto index = static_cast<std::size_t>(integer(0, static_cast<std::int64_t>(begins.size()) - 1));
  const double end = index + 1 < begins.size() ? begins[index + 1] : high;
  const std::string three_digits = fmt::format("{:.3g}", number(begins[index], end));
  return std::clamp(std::stod(three_digits), low, high);
}

}  // namespace armature::cosim
