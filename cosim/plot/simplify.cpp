#include "cosim/plot/simplify.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace armature::cosim {
namespace {

double squared_distance(PlotPoint p, PlotPoint a, PlotPoint b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length = dx * dx + dy * dy;
  const double along = length > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / length : 0;
  const double at = std::clamp(along, 0.0, 1.0);
  const double ex = p.x - a.x - at * dx;
  const double ey = p.y - a.y - at * dy;
  return ex * ex + ey * ey;
}

}  // namespace

std::vector<PlotPoint> simplify(const std::vector<PlotPoint>& points, double tolerance) {
  if (points.size() < 3) return points;
  std::vector<bool> kept(points.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double farthest = tolerance * tolerance;
    std::size_t at = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance = squared_distance(points[i], points[first], points[last]);
      if (distance > farthest) {
        farthest = distance;
        at = i;
      }
    }
    if (at == first) continue;
    kept[at] = true;
    open.emplace_back(first, at);
    open.emplace_back(at, last);
  }
  std::vector<PlotPoint> simplified;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (kept[i]) simplified.push_back(points[i]);
  }
  return simplified;
}

}  // namespace armature::cosim
