// Joints and tool along a short part of a path, as polynomials of its parameter, and how far these may be off.
//
// At some places of the path, samples, the joints and the tool are computed with their first and second derivatives.
// Between two samples a polynomial of degree 5 meets both. A third sample in the middle shows how good it is: a span is
// half of the way between two samples, and its polynomial meets that third sample, too.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "controller/base/axes.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/configuration.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"

namespace armature {

// A quantity of a span: a joint in rad, a coordinate of the tool point in mm, or of its rotation vector in rad. That
// one counts from the start of the span, and only its derivatives are valid.
class SpanCurve {
 public:
  static constexpr std::size_t kOrders = 5;

  struct End {
    double value = 0.0, slope = 0.0, bend = 0.0;  // derivatives by the parameter
  };
  SpanCurve() = default;
  // Between two ends at a distance of `length` > 0.
  SpanCurve(const End& first, const End& last, double length) noexcept;
  // The same of a quantity whose value is not known: by its slopes and bends.
  [[nodiscard]] static SpanCurve of_slopes(const End& first, const End& last, double length) noexcept;

  struct Derivatives {
    double first = 0.0, second = 0.0, third = 0.0;
  };
  // At a distance from the start.
  [[nodiscard]] double value(double after) const noexcept;
  [[nodiscard]] Derivatives at(double after) const noexcept;
  // The largest size of the derivative of this order, 1..kOrders, on the whole length, or more.
  [[nodiscard]] double most(std::size_t order) const noexcept { return most_[order - 1]; }

 private:
  void find_most(double length) noexcept;

  std::array<double, 6> c_{};  // of after^0 .. after^5
  std::array<double, kOrders> most_{};
};

struct SpanSample {
  static constexpr std::size_t kCurves = kAxes + 6;  // joints, tool point, rotation
  static constexpr std::size_t kMove = kAxes, kTurn = kAxes + 3;

  double s = 0.0;
  JointAngles joints{};
  std::array<SpanCurve::End, kCurves> ends{};
  Configuration sides{};  // of the arm, without turns
  double residual_rad = 0.0;
  bool found = false;  // all inverse kinematics have a solution that may be executed
  int inverses = 0;    // computed
};

// A part of the parameter on which the path has no break: between two corners, or a corner.
struct SmoothPart {
  double from = 0.0, to = 0.0;
};

// The sample at `s` of a part, computed from three places that are `delta` apart, or from four at an end of the part;
// no bend of the wrist is near. `near`: the joints at a close place.
[[nodiscard]] SpanSample sample_at(const CartesianPlan& plan, const Arm& arm, const SmoothPart& part, double s,
                                   double delta, const JointAngles& near) noexcept;

// How far the curves between two samples are off at a third one in the middle: value, first and second derivative.
struct SpanMisfit {
  std::array<SpanCurve::End, SpanSample::kCurves> off{};
};
[[nodiscard]] SpanMisfit misfit(const SpanSample& first, const SpanSample& middle, const SpanSample& last) noexcept;

struct PathSpan {
  double from = 0.0, to = 0.0;
  std::size_t segment = 0;  // whose limits apply
  bool exact_tool = false;  // a line or an arc: the curves of the tool are not used
  std::array<SpanCurve, SpanSample::kCurves> curves{};
  // The largest errors of their derivatives: first, second and third.
  std::array<SpanCurve::Derivatives, SpanSample::kCurves> errors{};
};
// Between the middle of a checked way and one of its ends.
[[nodiscard]] PathSpan span_between(const SpanSample& first, const SpanSample& last, const SpanMisfit& misfit) noexcept;

}  // namespace armature
