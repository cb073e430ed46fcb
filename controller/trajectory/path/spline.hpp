// A cubic spline through given points, by its length.
//
// The curve is the natural cubic spline of each coordinate over the sum of the chords between the points: C2, exact at
// the points, and without curvature at both ends. Its parameter has almost the size of a length, but not quite. So the
// length is integrated, and the parameter over the length is a C2 piecewise polynomial of degree 5 with the exact first
// and second derivatives at kParts + 1 places between two points. Any place by this function is exactly on the curve;
// its error only makes the speed along the curve differ, by less than 1e-5 where the curve bends by up to 40 degrees
// between its points, and by less than 1e-2 where it bends by 115.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace armature {

class Spline {
 public:
  static constexpr std::size_t kMaxPoints = 17;  // with the start and the end
  static constexpr std::size_t kParts = 8;       // of a piece between two points, in the table of lengths

  Spline() = default;  // no points
  // Copies only the points that there are.
  Spline(const Spline& other) noexcept { *this = other; }
  Spline& operator=(const Spline& other) noexcept;

  // Through 2..kMaxPoints points. Nothing if the number is another one, two successive points are closer than
  // kClosest_mm, a coordinate is not finite, or the curve has a point where it almost stops and turns back.
  static constexpr double kClosest_mm = 1e-3;
  [[nodiscard]] static std::optional<Spline> through(std::span<const Eigen::Vector3d> points_mm) noexcept;

  [[nodiscard]] std::span<const Eigen::Vector3d> points_mm() const noexcept { return {points_.data(), count_}; }
  [[nodiscard]] double length_mm() const noexcept { return length_[kParts * (count_ - 1)]; }
  // The length from the start to a point, 0..points_mm().size() - 1.
  [[nodiscard]] double length_to_mm(std::size_t point) const noexcept { return length_[kParts * point]; }
  // The curve from a point to the next one: its position is c[0] + c[1] u + c[2] u^2 + c[3] u^3, u = 0..1.
  [[nodiscard]] std::array<Eigen::Vector3d, 4> cubic_mm(std::size_t point) const noexcept;

  // The curve at a length from its start, 0..length_mm(): position, and its derivatives by the length.
  struct Place {
    Eigen::Vector3d position_mm = Eigen::Vector3d::Zero();
    Eigen::Vector3d tangent = Eigen::Vector3d::Zero();  // unit vector
    Eigen::Vector3d bend = Eigen::Vector3d::Zero();     // 1/mm, at a right angle to the tangent
    // 1/mm^2. It jumps at the points; there it is that of the curve after the point, at the end of the curve before it.
    Eigen::Vector3d jolt = Eigen::Vector3d::Zero();
  };
  [[nodiscard]] Place at(double length_mm) const noexcept;
  // Its position alone.
  [[nodiscard]] Eigen::Vector3d position_mm(double length_mm) const noexcept;

 private:
  // The curve at a parameter within the piece after `point`, 0..1, with derivatives by the sum of chords.
  struct Raw {
    Eigen::Vector3d position = Eigen::Vector3d::Zero(), slope = Eigen::Vector3d::Zero(), bend = Eigen::Vector3d::Zero();
  };
  struct Spot {
    std::size_t point = 0;
    double share = 0.0;
  };
  [[nodiscard]] double chord_mm(std::size_t point) const noexcept { return at_[point + 1] - at_[point]; }
  [[nodiscard]] Raw raw(const Spot& spot) const noexcept;
  [[nodiscard]] Eigen::Vector3d slope(const Spot& spot) const noexcept;
  [[nodiscard]] Spot spot(double length_mm) const noexcept;
  void bend_naturally() noexcept;
  [[nodiscard]] bool measure() noexcept;

  std::size_t count_ = 0;
  std::array<Eigen::Vector3d, kMaxPoints> points_{};
  std::array<Eigen::Vector3d, kMaxPoints> bends_{};  // second derivative at the points
  std::array<double, kMaxPoints> at_{};              // sum of chords
  std::array<double, kParts*(kMaxPoints - 1) + 1> length_{};
};

}  // namespace armature
