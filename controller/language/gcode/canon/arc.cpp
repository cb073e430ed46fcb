#include "controller/language/gcode/canon/arc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "controller/base/math.hpp"

namespace armature::gcode {
namespace {

constexpr double kLargestShare = 0.001;
constexpr double kLargestTolerances = 100.0;
constexpr double kFullTurn = 2.0 * std::numbers::pi;
// A smaller angle between start and end is none: the arc is a full circle.
constexpr double kNoAngle = 1e-12;

double distance(PlanePoint a, PlanePoint b) noexcept {
  return math::hypot(a.first - b.first, a.second - b.second);
}

}  // namespace

ArcCentre centre_from_radius(PlanePoint start, PlanePoint end, double radius, bool clockwise,
                             double tolerance_mm) noexcept {
  if (radius == 0.0) return ErrorCode::kArcZeroRadius;
  const double chord = distance(start, end);
  if (chord == 0.0) return ErrorCode::kArcFullCircleWithRadius;
  const double size = std::fabs(radius);
  if (chord / 2.0 - size > tolerance_mm) return ErrorCode::kArcRadiusTooSmall;
  const double height = std::sqrt(std::max(0.0, (size - chord / 2.0) * (size + chord / 2.0)));
  // The centre of a short clockwise arc lies to the right of the chord.
  const double left = clockwise == (radius > 0.0) ? -height : height;
  return PlanePoint{.first = (start.first + end.first) / 2.0 - left * (end.second - start.second) / chord,
                    .second = (start.second + end.second) / 2.0 + left * (end.first - start.first) / chord};
}

std::optional<ErrorCode> check_centre(PlanePoint start, PlanePoint end, PlanePoint centre,
                                      double tolerance_mm) noexcept {
  const double from = distance(start, centre);
  const double to = distance(end, centre);
  if (from < tolerance_mm || to < tolerance_mm) return ErrorCode::kArcZeroRadius;
  const double difference = std::fabs(from - to);
  const bool far_off = difference > kLargestTolerances * tolerance_mm;
  if (far_off || (difference > tolerance_mm && difference > kLargestShare * std::max(from, to))) {
    return ErrorCode::kArcRadiiDiffer;
  }
  return std::nullopt;
}

double arc_angle(PlanePoint start, PlanePoint end, PlanePoint centre, bool clockwise, int turns) noexcept {
  const double from = math::atan2(start.second - centre.second, start.first - centre.first);
  const double to = math::atan2(end.second - centre.second, end.first - centre.first);
  double angle = clockwise ? from - to : to - from;
  if (angle <= kNoAngle) angle += kFullTurn;
  if (angle <= kNoAngle) angle += kFullTurn;
  return angle + kFullTurn * (turns - 1);
}

double arc_length(PlanePoint start, PlanePoint end, PlanePoint centre, bool clockwise, int turns) noexcept {
  return distance(start, centre) * arc_angle(start, end, centre, clockwise, turns);
}

}  // namespace armature::gcode
