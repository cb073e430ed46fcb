#include "controller/trajectory/path/orientation_path.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "controller/base/math.hpp"

namespace armature {
namespace {

struct Quaternion {
  double w = 1.0;
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
};

// Shepperd's method divides by the largest of the four components, so none of them loses digits. The result is not
// normalised.
Quaternion quaternion(const Eigen::Matrix3d& m) {
  const std::array<double, 4> four_squares{1.0 + m(0, 0) - m(1, 1) - m(2, 2), 1.0 - m(0, 0) + m(1, 1) - m(2, 2),
                                           1.0 - m(0, 0) - m(1, 1) + m(2, 2), 1.0 + m(0, 0) + m(1, 1) + m(2, 2)};
  const auto largest = std::max_element(four_squares.begin(), four_squares.end()) - four_squares.begin();
  if (largest == 3) {
    return {four_squares[3], {m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)}};
  }
  const Eigen::Index i = largest, j = (i + 1) % 3, k = (i + 2) % 3;
  Quaternion q;
  q.w = m(k, j) - m(j, k);
  q.v[i] = four_squares[static_cast<std::size_t>(i)];
  q.v[j] = m(j, i) + m(i, j);
  q.v[k] = m(k, i) + m(i, k);
  return q;
}

}  // namespace

OrientationPath turn(const Eigen::Matrix3d& start, const Eigen::Matrix3d& end) noexcept {
  OrientationPath path;
  path.start = start;
  path.end = end;
  Quaternion q = quaternion(start.transpose() * end);
  const double v = math::hypot(math::hypot(q.v.x(), q.v.y()), q.v.z());
  if (v == 0.0) return path;
  Eigen::Index largest = 0;
  q.v.cwiseAbs().maxCoeff(&largest);
  const bool half_turn = std::fabs(q.w) <= 0.5 * kHalfTurnRounding_rad * v;
  const bool backwards = half_turn ? q.v[largest] < 0.0 : q.w < 0.0;  // q and -q are the same orientation
  path.axis = (backwards ? -q.v : q.v) / v;
  path.angle_rad = half_turn ? std::numbers::pi : 2.0 * math::atan2(v, std::fabs(q.w));
  return path;
}

OrientationPath turn_with(const PositionPath& path, const Eigen::Matrix3d& start) noexcept {
  OrientationPath result{.start = start, .end = start};
  if (path.shape != PositionPath::Shape::kArc) return result;
  result.axis = start.transpose() * path.x.cross(path.y);
  result.angle_rad = path.angle_rad;
  if (path.start_mm != path.end_mm) result.end = start * turned(result, 1.0);
  return result;
}

Eigen::Matrix3d rotation(const OrientationPath& path, double s) noexcept {
  if (s <= 0.0) return path.start;
  if (s >= 1.0) return path.end;
  return path.start * turned(path, s);
}

Eigen::Matrix3d turned(const OrientationPath& path, double s) noexcept {
  if (s <= 0.0 || path.angle_rad == 0.0) return Eigen::Matrix3d::Identity();
  // Rodrigues' formula with the half angle avoids the cancellation of 1 - cos.
  const math::SinCos half = math::sin_cos(0.5 * std::min(s, 1.0) * path.angle_rad);
  const double sine = 2.0 * half.sin * half.cos;
  const double versine = 2.0 * half.sin * half.sin;
  const Eigen::Vector3d a = sine * path.axis;
  Eigen::Matrix3d r = versine * (path.axis * path.axis.transpose());
  const double cosine = 1.0 - versine;
  r(0, 0) += cosine, r(1, 1) += cosine, r(2, 2) += cosine;
  r(0, 1) -= a.z(), r(1, 0) += a.z();
  r(0, 2) += a.y(), r(2, 0) -= a.y();
  r(1, 2) -= a.x(), r(2, 1) += a.x();
  return r;
}

}  // namespace armature
