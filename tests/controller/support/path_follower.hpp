// Follows set-points along the path that was asked for, in its order and without leaving anything out: each is near a
// place of the path that no earlier one has passed and that is no farther on than the tool has moved. What is kept is
// the range of the places that this leaves, so a path may cross or retrace itself, but a motion that goes back, takes a
// circle the wrong way round or does not draw it at all finds no place.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "controller/kinematics/transform.hpp"
#include "tests/controller/support/path_oracle.hpp"

namespace armature::test {

class PathFollower {
 public:
  // The 1e-11 rad by which a path may miss the wrist singularity, times 1 m, and some more.
  static constexpr double kOnPath_mm = 1e-7;
  // Of rotation matrices; around the wrist singularity theta_4 is kept, which turns the tool by 1e-7 rad at most.
  static constexpr double kRotation = 2e-7;

  // `with_rotation`: away from corners the tool has turned by as much of a piece's turn as it has covered of the piece.
  // `stop_mm`: the most that the tool covers from standing in a tick, which is what it may cover on either side of an
  // exact stop between two set-points, whatever is between these.
  PathFollower(const IdealPath& path, bool with_rotation, double stop_mm)
      : path_{path}, with_rotation_{with_rotation}, stop_mm_{stop_mm} {}

  // Where a set-point is: on one of these pieces, more than one next to an exact stop.
  struct Place {
    std::size_t first = 0, last = 0;
    bool in_corner = false;  // it may be off the path there, and the limits of several pieces hold
  };

  // Nothing when the path has no such place.
  [[nodiscard]] std::optional<Place> go_to(const Transform& tool) {
    const double allowed_mm = path_.allowed_mm(tool.position_mm);
    const double farthest = latest_ + (began_ ? farther(tool, std::max(allowed_mm, allowed_mm_)) : kBeside_mm);
    bool found = false;
    Place place{.in_corner = allowed_mm > 0.0};
    double first = 0.0, last = 0.0, begin = 0.0;
    for (std::size_t i = 0; i < path_.pieces().size(); ++i) {
      const IdealPiece& piece = path_.pieces()[i];
      const double extent = extent_of(piece);
      for (const ShareRange& range : ranges(piece, tool, std::max(allowed_mm, kOnPath_mm), allowed_mm == 0.0)) {
        const double from = std::max(begin + range.first * extent, earliest_);
        const double to = std::min(begin + range.last * extent, farthest);
        if (from > to) continue;
        if (!found || from < first) first = from;
        if (!found) place.first = i;
        last = found ? std::max(last, to) : to;
        found = true;
      }
      begin += extent;
    }
    if (!found) return std::nullopt;
    place.last = last_beside(place.first, tool.position_mm);
    earliest_ = first;
    latest_ = last;
    allowed_mm_ = allowed_mm;
    before_ = tool;
    began_ = true;
    return place;
  }

  // It may have arrived at the end of the path.
  [[nodiscard]] bool at_end() const {
    double all = 0.0;
    for (const IdealPiece& piece : path_.pieces()) all += extent_of(piece);
    return latest_ >= all - kBeside_mm;
  }

 private:
  static constexpr double kBeside_mm = 1e-6;

  // Places are measured in mm from the start of the path; a turn on the spot is as long as its angle in rad, with five
  // joints nothing.
  [[nodiscard]] double extent_of(const IdealPiece& piece) const {
    const double length_mm = piece.length_mm();
    return length_mm > 0.0 || !with_rotation_ ? length_mm : piece.turn_rad();
  }
  // How much farther on a set-point may be: an arc is less than twice its chord, a corner is cut.
  [[nodiscard]] double farther(const Transform& tool, double allowed_mm) const {
    const double turn_rad = (tool.rotation - before_.rotation).norm();  // sqrt(2) times the angle
    const double past_stop = at_stop() ? 2.0 * stop_mm_ : 0.0;
    return 2.0 * ((tool.position_mm - before_.position_mm).norm() + turn_rad) + past_stop + 4.0 * allowed_mm +
           kBeside_mm;
  }
  // The end of a piece is so near that there may have been an exact stop in between.
  [[nodiscard]] bool at_stop() const {
    double end = 0.0;
    for (const IdealPiece& piece : path_.pieces()) {
      end += extent_of(piece);
      if (end >= earliest_ && end <= latest_ + stop_mm_) return true;
    }
    return false;
  }

  [[nodiscard]] std::vector<ShareRange> ranges(const IdealPiece& piece, const Transform& tool, double tolerance_mm,
                                               bool exact) const {
    std::vector<ShareRange> all = piece.near(tool.position_mm, tolerance_mm);
    if (!with_rotation_ || !exact) return all;
    const double turn_rad = piece.turn_rad();
    if (piece.length_mm() == 0.0 && !all.empty() && turn_rad > 0.0) {
      const Eigen::AngleAxisd turn{Eigen::Matrix3d{piece.to.rotation * piece.from.rotation.transpose()}};
      const Eigen::Quaterniond done{Eigen::Matrix3d{tool.rotation * piece.from.rotation.transpose()}};
      const double share = 2.0 * std::atan2(done.vec().dot(turn.axis()), done.w()) / turn_rad;
      const double half = kRotation / turn_rad;
      all = {{std::max(share - half, 0.0), std::min(share + half, 1.0)}};
      if (all[0].first > all[0].last) return {};
    }
    std::erase_if(all, [&](const ShareRange& range) {
      const Eigen::Matrix3d ideal = piece.rotation(0.5 * (range.first + range.last));
      const double unknown_rad = 0.5 * (range.last - range.first) * turn_rad;
      return (tool.rotation - ideal).cwiseAbs().maxCoeff() > kRotation + unknown_rad;
    });
    return all;
  }

  // The last piece that begins where the set-point is, to rounding.
  [[nodiscard]] std::size_t last_beside(std::size_t piece, const Eigen::Vector3d& p) const {
    const std::vector<IdealPiece>& all = path_.pieces();
    while (piece + 1 < all.size() && (p - all[piece].to.position_mm).norm() < kBeside_mm) ++piece;
    return piece;
  }

  const IdealPath& path_;
  bool with_rotation_;
  double stop_mm_;
  bool began_ = false;
  double earliest_ = 0.0, latest_ = 0.0;  // where it may be
  double allowed_mm_ = 0.0;
  Transform before_{};
};

}  // namespace armature::test
