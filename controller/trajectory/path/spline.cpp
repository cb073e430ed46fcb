#include "controller/trajectory/path/spline.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace armature {
namespace {

// Of the mean speed over the parameter, 1. Below it the curve has a cusp, or almost one.
constexpr double kLeastCurveSpeed = 0.05;

// Gauss-Legendre over 0..1 with five nodes.
struct Node {
  double at, weight;
};
constexpr std::array<Node, 5> kNodes{{{0.04691007703066800, 0.1184634425280945},
                                      {0.2307653449471585, 0.2393143352496832},
                                      {0.5, 0.2844444444444444},
                                      {0.7692346550528415, 0.2393143352496832},
                                      {0.9530899229693320, 0.1184634425280945}}};

}  // namespace

Spline& Spline::operator=(const Spline& other) noexcept {
  count_ = other.count_;
  if (count_ == 0) return *this;
  std::copy_n(other.points_.begin(), count_, points_.begin());
  std::copy_n(other.bends_.begin(), count_, bends_.begin());
  std::copy_n(other.at_.begin(), count_, at_.begin());
  std::copy_n(other.length_.begin(), kParts * (count_ - 1) + 1, length_.begin());
  return *this;
}

std::optional<Spline> Spline::through(std::span<const Eigen::Vector3d> points_mm) noexcept {
  if (points_mm.size() < 2 || points_mm.size() > kMaxPoints) return std::nullopt;
  std::optional<Spline> result{std::in_place};
  Spline& spline = *result;
  spline.count_ = points_mm.size();
  std::copy(points_mm.begin(), points_mm.end(), spline.points_.begin());
  for (std::size_t i = 1; i < spline.count_; ++i) {
    const double chord = (spline.points_[i] - spline.points_[i - 1]).norm();
    // Written so that a NaN is refused.
    if (!(chord >= kClosest_mm) || !std::isfinite(chord)) return std::nullopt;
    spline.at_[i] = spline.at_[i - 1] + chord;
  }
  spline.bend_naturally();
  if (!spline.measure()) return std::nullopt;
  return result;
}

// Solves the tridiagonal equations for the second derivatives at the inner points.
void Spline::bend_naturally() noexcept {
  std::array<double, kMaxPoints> above{};
  bends_[0] = bends_[count_ - 1] = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < count_; ++i) {
    const double before = chord_mm(i - 1), after = chord_mm(i);
    const Eigen::Vector3d jump = 6.0 * ((points_[i + 1] - points_[i]) / after - (points_[i] - points_[i - 1]) / before);
    const double pivot = 2.0 * (before + after) - before * above[i - 1];
    above[i] = after / pivot;
    bends_[i] = (jump - before * bends_[i - 1]) / pivot;
  }
  for (std::size_t i = count_ - 1; i-- > 1;) bends_[i] -= above[i] * bends_[i + 1];
}

bool Spline::measure() noexcept {
  for (std::size_t i = 0; i + 1 < count_; ++i) {
    for (std::size_t part = 0; part < kParts; ++part) {
      double mean = 0.0;
      const auto speed_at = [&](double after) {
        return slope({i, (static_cast<double>(part) + after) / kParts}).norm();
      };
      if (!(speed_at(0.0) > kLeastCurveSpeed) || !(speed_at(1.0) > kLeastCurveSpeed)) return false;
      for (const Node& node : kNodes) {
        const double speed = speed_at(node.at);
        if (!(speed > kLeastCurveSpeed)) return false;
        mean += node.weight * speed;
      }
      const std::size_t index = kParts * i + part;
      length_[index + 1] = length_[index] + mean * chord_mm(i) / kParts;
    }
  }
  return std::isfinite(length_mm());
}

std::array<Eigen::Vector3d, 4> Spline::cubic_mm(std::size_t point) const noexcept {
  const double h = chord_mm(point);
  const Eigen::Vector3d &m = bends_[point], &n = bends_[point + 1];
  return {points_[point], h * slope({point, 0.0}), (h * h / 2.0) * m, (h * h / 6.0) * (n - m)};
}

Spline::Raw Spline::raw(const Spot& spot) const noexcept {
  const std::size_t i = spot.point;
  const double h = chord_mm(i), b = spot.share, a = 1.0 - b;
  const Eigen::Vector3d &p = points_[i], &q = points_[i + 1], &m = bends_[i], &n = bends_[i + 1];
  return {.position = a * p + b * q - (h * h / 6.0) * a * b * ((1.0 + a) * m + (1.0 + b) * n),
          .slope = slope(spot),
          .bend = a * m + b * n};
}

Eigen::Vector3d Spline::slope(const Spot& spot) const noexcept {
  const std::size_t i = spot.point;
  const double h = chord_mm(i), b = spot.share, a = 1.0 - b;
  return (points_[i + 1] - points_[i]) / h +
         (h / 6.0) * ((1.0 - 3.0 * a * a) * bends_[i] + (3.0 * b * b - 1.0) * bends_[i + 1]);
}

// The parameter over the length: the polynomial of degree 5 between two entries of the table.
Spline::Spot Spline::spot(double length_mm) const noexcept {
  const auto end = length_.begin() + static_cast<std::ptrdiff_t>(kParts * (count_ - 1));
  const auto above = std::upper_bound(length_.begin() + 1, end, length_mm);
  const auto part = static_cast<std::size_t>(above - length_.begin()) - 1;
  const std::size_t i = part / kParts;
  const double begin = static_cast<double>(part % kParts) / kParts, h = length_[part + 1] - length_[part];
  const double u = (length_mm - length_[part]) / h;
  // Both derivatives of the share of the piece by u.
  const auto derivatives = [&](double share) {
    const Raw place = raw({i, share});
    const double speed2 = place.slope.squaredNorm(), chord = chord_mm(i);
    const double first = h / (std::sqrt(speed2) * chord);
    return std::array{first, -h * h * place.slope.dot(place.bend) / (speed2 * speed2 * chord)};
  };
  const auto a = derivatives(begin), b = derivatives(begin + 1.0 / kParts);
  const double whole = 1.0 / kParts;
  const double c0 = whole - a[0] - 0.5 * a[1], c1 = b[0] - a[0] - a[1], c2 = b[1] - a[1];
  const double third = 10.0 * c0 - 4.0 * c1 + 0.5 * c2, fourth = -15.0 * c0 + 7.0 * c1 - c2;
  const double fifth = 6.0 * c0 - 3.0 * c1 + 0.5 * c2;
  const double share = begin + u * (a[0] + u * (0.5 * a[1] + u * (third + u * (fourth + u * fifth))));
  return {i, std::clamp(share, 0.0, 1.0)};
}

Spline::Place Spline::at(double length_mm) const noexcept {
  const Spot here = spot(length_mm);
  const Raw place = raw(here);
  const Eigen::Vector3d third = (bends_[here.point + 1] - bends_[here.point]) / chord_mm(here.point);
  const double speed2 = place.slope.squaredNorm(), speed = std::sqrt(speed2);
  // The derivatives of the parameter by the length: 1 / speed, and those of it along the curve.
  const double along = place.slope.dot(place.bend) / speed2;
  const double change = (place.bend.squaredNorm() + place.slope.dot(third)) / speed2;
  const Eigen::Vector3d across = place.bend - along * place.slope;
  return {.position_mm = place.position,
          .tangent = place.slope / speed,
          .bend = across / speed2,
          .jolt = (third - 3.0 * along * place.bend + (4.0 * along * along - change) * place.slope) / (speed * speed2)};
}

Eigen::Vector3d Spline::position_mm(double length_mm) const noexcept {
  return raw(spot(length_mm)).position;
}

}  // namespace armature
