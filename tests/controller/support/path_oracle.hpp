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
#include "controller/trajectory/path/segment_request.hpp"

namespace armature::test {

struct ShareRange {
  double first = 0.0, last = 0.0;
};

// A piece of the ideal path, or of nothing but turning.
struct IdealPiece {
  Transform from{}, to{};
  bool round = false;
  Eigen::Vector3d center_mm = Eigen::Vector3d::Zero(), x = Eigen::Vector3d::Zero(), y = Eigen::Vector3d::Zero();
  double radius_mm = 0.0;
  double sweep_rad = 0.0;

  [[nodiscard]] Eigen::Vector3d way_mm() const { return to.position_mm - from.position_mm; }
  [[nodiscard]] double length_mm() const { return round ? radius_mm * sweep_rad : way_mm().norm(); }
  [[nodiscard]] double turn_rad() const {
    return Eigen::AngleAxisd{Eigen::Matrix3d{to.rotation * from.rotation.transpose()}}.angle();
  }
  // The shares of the piece, 0..1, that are within `tolerance_mm` of a point. A circle has two ranges where it closes.
  [[nodiscard]] std::vector<ShareRange> near(const Eigen::Vector3d& p, double tolerance_mm) const {
    return round ? near_on_arc(p, tolerance_mm) : near_on_line(p, tolerance_mm);
  }
  // The tool's rotation at `share` of the piece.
  [[nodiscard]] Eigen::Matrix3d rotation(double share) const {
    const Eigen::AngleAxisd turn{Eigen::Matrix3d{to.rotation * from.rotation.transpose()}};
    return Eigen::AngleAxisd{share * turn.angle(), turn.axis()}.toRotationMatrix() * from.rotation;
  }

 private:
  static void add_clipped(std::vector<ShareRange>& ranges, double first, double last) {
    if (first <= 1.0 && last >= 0.0) ranges.push_back({std::max(first, 0.0), std::min(last, 1.0)});
  }
  [[nodiscard]] std::vector<ShareRange> near_on_line(const Eigen::Vector3d& p, double tolerance_mm) const {
    const Eigen::Vector3d away = p - from.position_mm;
    const double length = length_mm();
    std::vector<ShareRange> ranges;
    if (length == 0.0) {
      if (away.norm() <= tolerance_mm) ranges.push_back({0.0, 1.0});
      return ranges;
    }
    const double along = way_mm().dot(away) / length;
    const double beside = (away - along / length * way_mm()).norm();
    if (beside > tolerance_mm) return ranges;
    const double half = std::sqrt(tolerance_mm * tolerance_mm - beside * beside);
    add_clipped(ranges, (along - half) / length, (along + half) / length);
    return ranges;
  }
  // |p - circle(phi)|^2 = h^2 + (rho - r)^2 + 4 rho r sin^2((phi - phi_0) / 2)
  [[nodiscard]] std::vector<ShareRange> near_on_arc(const Eigen::Vector3d& p, double tolerance_mm) const {
    const Eigen::Vector3d d = p - center_mm;
    const double rho = std::hypot(d.dot(x), d.dot(y)), height = d.dot(x.cross(y));
    const double left = tolerance_mm * tolerance_mm - height * height - (rho - radius_mm) * (rho - radius_mm);
    std::vector<ShareRange> ranges;
    if (left < 0.0) return ranges;
    const double sine2 = left / (4.0 * rho * radius_mm);
    if (!(sine2 < 1.0)) return {{0.0, 1.0}};
    const double half = 2.0 * std::asin(std::sqrt(sine2)), phi = std::atan2(d.dot(y), d.dot(x));
    for (const double turns : {-1.0, 0.0, 1.0}) {
      const double middle = phi + turns * 2.0 * std::numbers::pi;
      add_clipped(ranges, (middle - half) / sweep_rad, (middle + half) / sweep_rad);
    }
    return ranges;
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

  // How far a point may leave the path where it is: near a corner by its blend_mm.
  [[nodiscard]] double allowed_mm(const Eigen::Vector3d& p) const {
    double most = 0.0;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (blend_mm_[i] == 0.0 || (p - pieces_[i].to.position_mm).norm() > zone_mm(i)) continue;
      most = std::max(most, blend_mm_[i]);
    }
    return most;
  }

  [[nodiscard]] const std::vector<IdealPiece>& pieces() const { return pieces_; }

 private:
  // How far from a corner the path may be rounded. Trapezoids: up to half of the shorter piece; between lines so far
  // that the corner point is missed by blend_mm, which is 3/16 of this and of the change of direction. S-curves: 2
  // blend_mm.
  [[nodiscard]] double zone_mm(std::size_t i) const {
    const IdealPiece &a = pieces_[i], &b = pieces_[i + 1];
    double zone = 0.5 * std::min(a.length_mm(), b.length_mm());
    if (!a.round && !b.round && zone > 0.0) {
      const double change = (b.way_mm() / b.length_mm() - a.way_mm() / a.length_mm()).norm();
      zone = std::min(zone, 16.0 / 3.0 * blend_mm_[i] / change);
    }
    return std::max(zone, 2.0 * blend_mm_[i]) + 1e-9;
  }

  std::vector<IdealPiece> pieces_;
  std::vector<double> blend_mm_;  // [i]: at the end of piece i
};

}  // namespace armature::test
