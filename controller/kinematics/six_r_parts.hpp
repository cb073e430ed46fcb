// Parts of the closed forms of SixR, for its source files and for the choice of Arm.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "controller/base/math.hpp"
#include "controller/kinematics/six_r.hpp"
#include "controller/kinematics/turns.hpp"

namespace armature {

// The distance of the joints from the previous ones. Equal largest steps are ordered by the sum of squares.
struct JointStep {
  double largest = std::numeric_limits<double>::infinity();
  double squares = std::numeric_limits<double>::infinity();

  JointStep() noexcept = default;
  JointStep(const Theta& theta, const Theta& previous) noexcept : largest{0.0}, squares{0.0} {
    for (std::size_t i = 0; i < theta.size(); ++i) {
      const double step = std::fabs(theta[i] - previous[i]);
      largest = std::max(largest, step);
      squares += step * step;
    }
  }
  [[nodiscard]] bool shorter_than(const JointStep& other) const noexcept {
    return largest != other.largest ? largest < other.largest : squares < other.squares;
  }
};

// Arctangents that are computed together, which takes half the time.
class SixR::Arctangents {
 public:
  void add(double y, double x) noexcept {
    y_[count_] = y;
    x_[count_++] = x;
  }
  void compute() noexcept {
    math::atan2_each(std::span{y_}.first(count_), std::span{x_}.first(count_), std::span{angle_}.first(count_));
  }
  [[nodiscard]] double operator[](std::size_t i) const noexcept { return angle_[i]; }

 private:
  static constexpr std::size_t kMax = 12;  // four wrists
  std::array<double, kMax> y_, x_, angle_;
  std::size_t count_ = 0;
};

// Joint 1, and the vertical plane of the arm that follows from it.
struct SixR::Shoulder {
  double theta1;  // [-pi, pi]
  double s1, c1;
  bool singular;

  [[nodiscard]] Shoulder back() const noexcept { return {opposite(theta1), -s1, -c1, singular}; }
};

// The triangle of upper arm a2, forearm k and distance to the wrist centre.
struct SixR::Triangle {
  double x, y;             // from axis 2 to the wrist centre, in the plane of the arm
  double distance2;        // x^2 + y^2
  double area;             // 2 a2 k |sin(theta_3 - phi)|
  double margin_mm = 0.0;  // > 0: unreachable; the angles stretch or fold the arm towards it
  std::uint8_t singular = 0;
  bool clamped = false;
};

// Joints 2 and 3 of both elbows: index 0 is elbow +1, 1 is elbow -1.
struct SixR::Elbow {
  double theta2[2], theta3[2];  // [-pi, pi]
};

// The orientation of the flange, seen from the plane of the arm.
struct SixR::Hand {
  Eigen::RowVector3d outward, upward, across;

  Hand(const Shoulder& shoulder, const Eigen::Matrix3d& rotation) noexcept
      : outward{shoulder.c1 * rotation.row(0) + shoulder.s1 * rotation.row(1)},
        upward{rotation.row(2)},
        across{shoulder.s1 * rotation.row(0) - shoulder.c1 * rotation.row(1)} {}
};

// Joints 1 to 3 of all branches of a pose, without the wrists, in the order of the branches.
struct SixR::Arms {
  struct Side {
    Shoulder shoulder;
    Triangle triangle;
    Hand hand;
  };
  struct Posed {
    std::size_t side, bend;  // 0: +1, 1: -1
    double theta2, theta3;
  };
  static constexpr std::size_t kMax = 4;

  std::array<Side, 2> sides;
  std::array<Posed, kMax> posed{};  // both bends of each side that reaches
  std::size_t count = 0;
  double margin_mm = 0.0;  // count 0: of the side that misses by least
};

}  // namespace armature
