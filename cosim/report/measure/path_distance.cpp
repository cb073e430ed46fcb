#include "cosim/report/measure/path_distance.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "controller/base/math.hpp"

namespace armature::cosim {
namespace {

using Eigen::Vector3d;

// The share of the way from start to end, 0..1, at which the segment is nearest to the point.
double nearest_share(const Vector3d& start, const Vector3d& end, const Vector3d& point) {
  const Vector3d along = end - start;
  const double square = along.squaredNorm();
  return square > 0 ? std::clamp(along.dot(point - start) / square, 0.0, 1.0) : 0.0;
}

double distance_to_segment(const Vector3d& start, const Vector3d& end, const Vector3d& point) {
  return (start + nearest_share(start, end, point) * (end - start) - point).norm();
}

// A search for the nearest point of curves at(u), u from 0 to 1. Between u = a and b a curve is nowhere farther from
// its chord than (b - a)^2 / 8 times its largest second derivative. So the distance to the chord less this is a lower
// bound for the whole range. A range is halved until its bound shows that it has no point nearer than the nearest one
// that is known. No sharp bend can hide the nearest point, as it can from a search that begins at samples.
class NearestPoint {
 public:
  static constexpr int kHalvings = 50;  // of a curve; beyond them are only rounding errors

  explicit NearestPoint(const Vector3d& point) : point_{point} {}

  // `most_bend(a, b)` is the largest size of the second derivative between them.
  template <class At, class MostBend>
  void search(At at, MostBend most_bend) {
    struct Range {
      double a = 0, b = 0;
      Vector3d start, end;
    };
    // One range of each width waits at most.
    std::array<Range, kHalvings + 2> waiting;
    std::size_t count = 0;
    const auto add = [&](const Range& range) { waiting[count++] = range; };
    add({0, 1, at(0), at(1)});
    visit(waiting[0].start);
    const double least_width = std::ldexp(1.0, -kHalvings);
    while (count > 0) {
      const Range range = waiting[--count];
      const double width = range.b - range.a;
      const double share = nearest_share(range.start, range.end, point_);
      const double to_chord = (range.start + share * (range.end - range.start) - point_).norm();
      const double bound = to_chord - width * width / 8 * most_bend(range.a, range.b);
      if (bound >= least_ - tolerance()) continue;
      visit(at(range.a + share * width));
      if (bound >= least_ - tolerance() || width <= least_width) continue;
      const double middle = range.a + width / 2;
      const Vector3d halfway = at(middle);
      const Range first{range.a, middle, range.start, halfway}, second{middle, range.b, halfway, range.end};
      // The nearer half comes last, so that it is searched first.
      add(share < 0.5 ? second : first);
      add(share < 0.5 ? first : second);
    }
  }

  [[nodiscard]] double mm() const { return least_; }

 private:
  [[nodiscard]] double tolerance() const { return 1e-10 + 1e-7 * least_; }
  void visit(const Vector3d& place) { least_ = std::min(least_, (place - point_).norm()); }

  const Vector3d& point_;
  double least_ = std::numeric_limits<double>::max();
};

// The smallest s from 0 to pi with a sin(s) + b s = c; a, b, c >= 0. NaN: there is none. The left side is concave and
// first rises, so Newton's method comes nearer from below and cannot pass the solution.
double smallest_root(double a, double b, double c) {
  constexpr double kConverged = 1e-8;  // the next step would be some square of this
  constexpr int kMaxSteps = 100;       // where two solutions meet, each halves the error
  double s = 0;
  for (int i = 0; i < kMaxSteps; ++i) {
    const math::SinCos at = math::sin_cos(s);
    const double slope = a * at.cos + b;
    const double step = (c - a * at.sin - b * s) / slope;
    if (!(slope > 0) || s + step > std::numbers::pi) return std::numeric_limits<double>::quiet_NaN();
    s += step;
    if (step < kConverged) break;
  }
  return s;
}

// In the frame of the helix the point has a distance r from the axis, an angle, and a height h. With s = phi - angle,
// the square of the distance is (r - radius)^2 + 4 r radius sin(s/2)^2 + (h - rise phi)^2. It has at most one minimum
// in each turn |s| <= pi. That is between s = 0 and the phi of the height h. The turn nearest to that phi has the
// lowest one.
double distance_to_helix(const PositionPath& helix, const Vector3d& point) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const Vector3d from_center = point - helix.center_mm;
  const double x = from_center.dot(helix.x);
  const double y = from_center.dot(helix.y);
  const double height = from_center.dot(helix.x.cross(helix.y));
  const double from_axis = std::sqrt(x * x + y * y);
  const double angle = math::atan2(y, x);
  const double rise = helix.advance_mm / helix.angle_rad;
  const double product = from_axis * helix.radius_mm;

  double least = std::min((point - helix.start_mm).squaredNorm(), (point - helix.end_mm).squaredNorm());
  // Returns whether the helix has the minimum of this turn.
  const auto visit = [&](double turn) {
    const double middle = angle + turn * kTurn;
    const double ahead = rise * (height - rise * middle);
    const double s = std::copysign(smallest_root(product, rise * rise, std::fabs(ahead)), ahead);
    const double phi = middle + s;
    if (!(phi >= 0 && phi <= helix.angle_rad)) return false;
    const double half = math::sin_cos(s / 2).sin;
    const double outward = from_axis - helix.radius_mm, along = height - rise * phi;
    least = std::min(least, outward * outward + 4 * product * half * half + along * along);
    return true;
  };
  const auto turn_of = [&](double phi) { return std::round((phi - angle) / kTurn); };
  const double nearest = std::clamp(turn_of(height / rise), turn_of(0), turn_of(helix.angle_rad));
  if (!visit(nearest)) {
    visit(nearest - 1);
    visit(nearest + 1);
  }
  return std::sqrt(least);
}

double distance_to_spline(const Spline& spline, const Vector3d& point) {
  NearestPoint nearest{point};
  for (std::size_t i = 0; i + 1 < spline.points_mm().size(); ++i) {
    const std::array<Vector3d, 4> c = spline.cubic_mm(i);
    const auto at = [&](double u) -> Vector3d { return c[0] + u * (c[1] + u * (c[2] + u * c[3])); };
    const auto bend = [&](double u) { return (2 * c[2] + 6 * u * c[3]).norm(); };
    // The second derivative is linear, so it is largest at an end.
    nearest.search(at, [&](double a, double b) { return std::max(bend(a), bend(b)); });
  }
  return nearest.mm();
}

double distance_to_arc(const PositionPath& arc, const Vector3d& point) {
  if (arc.advance_mm != 0) return distance_to_helix(arc, point);
  const Vector3d from_center = point - arc.center_mm;
  const double u = from_center.dot(arc.x);
  const double v = from_center.dot(arc.y);
  const double height = from_center.dot(arc.x.cross(arc.y));
  double angle = std::atan2(v, u);
  if (angle < 0) angle += 2 * std::numbers::pi;
  if (angle <= arc.angle_rad) return std::hypot(std::hypot(u, v) - arc.radius_mm, height);
  return std::min((point - arc.start_mm).norm(), (point - arc.end_mm).norm());
}

Ball ball_of(const std::vector<Vector3d>& points) {
  Ball ball{.center_mm = (points.front() + points.back()) / 2};
  for (const Vector3d& point : points) ball.radius_mm = std::max(ball.radius_mm, (point - ball.center_mm).norm());
  return ball;
}

}  // namespace

Ball ball_around(const PositionPath& path) {
  if (path.shape == PositionPath::Shape::kArc) {
    const Vector3d half_advance = path.x.cross(path.y) * (path.advance_mm / 2);
    return {.center_mm = path.center_mm + half_advance,
            .radius_mm = std::sqrt(path.radius_mm * path.radius_mm + half_advance.squaredNorm())};
  }
  std::vector<Vector3d> points{path.start_mm, path.end_mm};
  if (path.shape == PositionPath::Shape::kSpline) {
    // A cubic is in the hull of its control points.
    for (std::size_t i = 0; i + 1 < path.spline->points_mm().size(); ++i) {
      const std::array<Vector3d, 4> c = path.spline->cubic_mm(i);
      const Vector3d second = c[0] + c[1] / 3;
      points.insert(points.begin() + 1, {second, second + (c[1] + c[2]) / 3, c[0] + c[1] + c[2] + c[3]});
    }
  }
  return ball_of(points);
}

double distance_mm(const PositionPath& path, const Vector3d& point_mm) {
  switch (path.shape) {
    case PositionPath::Shape::kLine:
      break;
    case PositionPath::Shape::kArc:
      return distance_to_arc(path, point_mm);
    case PositionPath::Shape::kSpline:
      return distance_to_spline(*path.spline, point_mm);
  }
  return distance_to_segment(path.start_mm, path.end_mm, point_mm);
}

}  // namespace armature::cosim
