// The path that was asked for, from the requests alone: for judging set-points without the planner's own geometry.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "controller/kinematics/transform.hpp"
#include "controller/trajectory/segment_request.hpp"

namespace armature::test {

// A piece of the ideal path, or of nothing but turning.
struct IdealPiece {
  Transform from{}, to{};
  bool round = false;
  Eigen::Vector3d center_mm = Eigen::Vector3d::Zero(), x = Eigen::Vector3d::Zero(), y = Eigen::Vector3d::Zero();
  double radius_mm = 0.0;
  double sweep_rad = 0.0;

  [[nodiscard]] double distance_mm(const Eigen::Vector3d& p) const {
    const double to_ends = std::min((p - from.position_mm).norm(), (p - to.position_mm).norm());
    if (round) {
      const Eigen::Vector3d d = p - center_mm;
      double phi = std::atan2(d.dot(y), d.dot(x));
      if (phi < 0.0) phi += 2.0 * std::numbers::pi;
      if (phi > sweep_rad) return to_ends;
      return std::hypot(std::hypot(d.dot(x), d.dot(y)) - radius_mm, d.dot(x.cross(y)));
    }
    const double s = share(p);
    return s > 0.0 && s < 1.0 ? (p - from.position_mm - s * way_mm()).norm() : to_ends;
  }
  [[nodiscard]] Eigen::Vector3d way_mm() const { return to.position_mm - from.position_mm; }
  // Of a line.
  [[nodiscard]] double share(const Eigen::Vector3d& p) const {
    return way_mm().dot(p - from.position_mm) / way_mm().squaredNorm();
  }
  // The tool's rotation where a line has covered `share`.
  [[nodiscard]] Eigen::Matrix3d rotation(double share) const {
    const Eigen::AngleAxisd turn{Eigen::Matrix3d{to.rotation * from.rotation.transpose()}};
    return Eigen::AngleAxisd{share * turn.angle(), turn.axis()}.toRotationMatrix() * from.rotation;
  }
};

// Of a request with three different points; the planner refuses the others.
inline IdealPiece ideal_piece(const Transform& from, const SegmentRequest& request) {
  IdealPiece piece{.from = from, .to = request.target};
  if (request.kind == SegmentRequest::Kind::kLine) return piece;
  const Eigen::Vector3d b = request.via_mm - from.position_mm, c = request.target.position_mm - from.position_mm;
  const Eigen::Vector3d normal = b.cross(c);
  // Centre of the circle through 0, b and c.
  const Eigen::Vector3d center =
      (b.squaredNorm() * c.cross(normal) + c.squaredNorm() * normal.cross(b)) / (2.0 * normal.squaredNorm());
  piece.round = true;
  piece.radius_mm = center.norm();
  piece.center_mm = from.position_mm + center;
  piece.x = -center.normalized();
  piece.y = normal.normalized().cross(piece.x);
  piece.sweep_rad = 2.0 * std::numbers::pi;
  if (request.kind == SegmentRequest::Kind::kCircle) {
    piece.to.position_mm = from.position_mm;
  } else {
    const Eigen::Vector3d end = c - center;
    piece.sweep_rad = std::atan2(end.dot(piece.y), end.dot(piece.x));
    if (piece.sweep_rad < 0.0) piece.sweep_rad += 2.0 * std::numbers::pi;
  }
  return piece;
}

class IdealPath {
 public:
  IdealPath(const Transform& start, std::span<const SegmentRequest> chain) {
    Transform from = start;
    for (const SegmentRequest& request : chain) {
      pieces_.push_back(ideal_piece(from, request));
      from = pieces_.back().to;
      blend_mm_.push_back(request.blend_mm);
    }
    blend_mm_.back() = 0.0;
  }

  [[nodiscard]] const Transform& end() const { return pieces_.back().to; }

  // What a point is away from the path, and what it may: a corner that is left by b is left within 2 b of it.
  struct Miss {
    double distance_mm = std::numeric_limits<double>::infinity();
    double allowed_mm = 0.0;
    std::size_t nearest = 0;
  };
  [[nodiscard]] Miss miss(const Eigen::Vector3d& p) const {
    Miss result;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const double distance_mm = pieces_[i].distance_mm(p);
      if (distance_mm < result.distance_mm) {
        result.distance_mm = distance_mm;
        result.nearest = i;
      }
      if (blend_mm_[i] > 0.0 && (p - pieces_[i].to.position_mm).norm() <= 2.0 * blend_mm_[i]) {
        result.allowed_mm = std::max(result.allowed_mm, blend_mm_[i]);
      }
    }
    return result;
  }

  [[nodiscard]] const std::vector<IdealPiece>& pieces() const { return pieces_; }

 private:
  std::vector<IdealPiece> pieces_;
  std::vector<double> blend_mm_;  // [i]: at the end of piece i
};

}  // namespace armature::test
