#include "controller/trajectory/check/path_span.hpp"

#include <algorithm>
#include <cmath>

#include "controller/trajectory/cartesian/wrist_bend.hpp"

namespace armature {
namespace {

// The derivatives of the curves over both halves of a way of length L are off by at most
//   first    value V / L      + slope S         + bend B L
//   second   value V / L^2    + slope S / L     + bend B
//   third    value V / L^3    + slope S / L^2   + bend B / L
// where V, S and B are what the curve over the whole way is off in its middle (SpanMisfit), with these factors. They
// follow from the errors that a way can have:
//   - A polynomial of degree 5 that meets value, slope and bend at both ends differs from a smooth curve by
//     (x (1 - x))^3 (k + m (x - 1/2)), x = 0..1. So V = k / 64 and S = m / (64 L). On half of the way k is a 64th.
//     There m adds up to 3.5 times as much. Derivatives of (x (1 - x))^3 are up to 3.43, 24 and 384 times its largest
//     value.
//   - Slopes and bends of samples come from differences. An error that all three samples have shows 1.9 times in S if
//     it is one of slopes, and 1.5 times in B if it is one of bends. It makes the derivatives of the halves wrong by up
//     to 1, 12 / L and 240 / L^2 times the error of slopes, or L / 20, 1 and 24 / L times that of bends.
struct ErrorFactors {
  double value, slope, bend;
};
using Factors = std::array<ErrorFactors, 3>;
constexpr Factors kOfValue{{{0.11, 0.7, 0.05}, {1.5, 7.0, 1.0}, {48.0, 168.0, 24.0}}};
// The same of a curve that is known by its slopes. A polynomial of degree 3 for them is off by
// (x (1 - x))^2 (k + m (x - 1/2)), so S = k / 16 and B = m / (16 L).
constexpr Factors kOfSlopes{{{0.0, 1.0, 0.3}, {0.0, 2.0, 1.5}, {0.0, 12.0, 20.0}}};

SpanCurve::Derivatives errors_of(const SpanCurve::End& off, double length, const Factors& factors) {
  std::array<double, 3> errors{};
  double power = 1.0 / length;
  for (std::size_t i = 0; i < errors.size(); ++i, power /= length) {
    const auto& [value, slope, bend] = factors[i];
    errors[i] = (value * off.value + (slope * off.slope + bend * off.bend * length) * length) * power;
  }
  return {errors[0], errors[1], errors[2]};
}

}  // namespace

SpanCurve::SpanCurve(const End& first, const End& last, double length) noexcept {
  c_ = bend_between({.angle = first.value, .slope = first.slope, .bend = first.bend},
                    {.angle = last.value, .slope = last.slope, .bend = last.bend}, length);
  find_most(length);
}

SpanCurve SpanCurve::of_slopes(const End& first, const End& last, double length) noexcept {
  SpanCurve curve;
  const double change = last.slope - first.slope, b0 = first.bend * length, b1 = last.bend * length;
  curve.c_ = {0.0,
              first.slope * length,
              0.5 * b0 * length,
              (change - (2.0 * b0 + b1) / 3.0) * length,
              0.25 * (b0 + b1 - 2.0 * change) * length,
              0.0};
  curve.find_most(length);
  return curve;
}

// The coefficients are those of after / length. They become those of `after`.
void SpanCurve::find_most(double length) noexcept {
  const auto largest = [](double a, double b, double c) {
    return std::max({std::fabs(a), std::fabs(b), std::fabs(c)});
  };
  // By the coefficients of Bernstein, which contain a polynomial between them.
  most_[2] = largest(6.0 * c_[3], 6.0 * c_[3] + 12.0 * c_[4], 6.0 * c_[3] + 24.0 * c_[4] + 60.0 * c_[5]);
  most_[3] = std::max(std::fabs(24.0 * c_[4]), std::fabs(24.0 * c_[4] + 120.0 * c_[5]));
  most_[4] = std::fabs(120.0 * c_[5]);
  const double bend = 2.0 * c_[2], end_bend = bend + 6.0 * c_[3] + 12.0 * c_[4] + 20.0 * c_[5];
  most_[1] = std::max(std::fabs(bend), std::fabs(end_bend)) + most_[3] / 8.0;
  const double end_slope = c_[1] + 2.0 * c_[2] + 3.0 * c_[3] + 4.0 * c_[4] + 5.0 * c_[5];
  most_[0] = std::max(std::fabs(c_[1]), std::fabs(end_slope)) + most_[2] / 8.0;
  double power = 1.0;
  for (std::size_t i = 1; i <= kOrders; ++i) {
    power /= length;
    c_[i] *= power;
    most_[i - 1] *= power;
  }
}

double SpanCurve::value(double x) const noexcept {
  return c_[0] + x * (c_[1] + x * (c_[2] + x * (c_[3] + x * (c_[4] + x * c_[5]))));
}

SpanCurve::Derivatives SpanCurve::at(double x) const noexcept {
  return {c_[1] + x * (2.0 * c_[2] + x * (3.0 * c_[3] + x * (4.0 * c_[4] + x * 5.0 * c_[5]))),
          2.0 * c_[2] + x * (6.0 * c_[3] + x * (12.0 * c_[4] + x * 20.0 * c_[5])),
          6.0 * c_[3] + x * (24.0 * c_[4] + x * 60.0 * c_[5])};
}

SpanSample sample_at(const CartesianPlan& plan, const Arm& arm, const SmoothPart& part, double s, double delta,
                     const JointAngles& near) noexcept {
  SpanSample sample{.s = s, .joints = near, .found = true};
  // At an end of the part the other places are on one side of it.
  const bool forward = s - delta < part.from, one_side = forward || s + delta > part.to;
  const double step = one_side && !forward ? -delta : delta;
  const std::array<double, 4> places{s, s + step, one_side ? s + 2.0 * step : s - step, s + 3.0 * step};
  const std::size_t count = one_side ? 4 : 3;
  std::array<ToolSample, 4> tools;
  std::array<JointAngles, 4> joints{};
  for (std::size_t i = 0; i < count; ++i) {
    tools[i] = tool_on_path(plan, places[i]);
    const JointAngles& previous = i == 0 ? near : joints[0];
    joints[i] = previous;
    if (tools[i].tool.missing_mm > 0.0) return sample.found = false, sample;
    const IkTracking there = arm.track_keeping_elbow(tools[i].tool.base_T_tool * plan.tool_T_flange, previous);
    ++sample.inverses;
    sample.found = sample.found && there.found && there.status == IkStatus::kOk;
    if (there.found) joints[i] = there.joints;
    if (i == 0) sample.residual_rad = there.residual_rad;
  }
  sample.joints = joints[0];
  sample.sides = arm.configuration(joints[0]);
  sample.sides.turns.reset();
  // Differences of second order: their errors are those of the next derivatives, times the square of the step.
  const auto end_of_curve = [&](double y0, double y1, double y2, double y3) -> SpanCurve::End {
    if (!one_side) return {y0, (y1 - y2) / (2.0 * step), (y1 - 2.0 * y0 + y2) / (step * step)};
    return {y0, (-11.0 * y0 + 18.0 * y1 - 9.0 * y2 + 2.0 * y3) / (6.0 * step),
            (2.0 * y0 - 5.0 * y1 + 4.0 * y2 - y3) / (step * step)};
  };
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const auto at = [&](std::size_t k) { return joints[k][axis].value(); };
    sample.ends[axis] = end_of_curve(at(0), at(1), at(2), at(3));
  }
  std::array<Eigen::Vector3d, 4> turns;
  for (std::size_t k = 0; k < turns.size(); ++k) {
    turns[k] = k == 0 || k >= count ? Eigen::Vector3d::Zero() : limited_turn(tools[0], tools[k]);
  }
  for (Eigen::Index i = 0; i < 3; ++i) {
    const auto at = [&](std::size_t k) { return tools[k].tool.base_T_tool.position_mm[i]; };
    const auto curve = static_cast<std::size_t>(i);
    sample.ends[SpanSample::kMove + curve] = end_of_curve(at(0), at(1), at(2), at(3));
    sample.ends[SpanSample::kTurn + curve] = end_of_curve(0.0, turns[1][i], turns[2][i], turns[3][i]);
  }
  return sample;
}

SpanMisfit misfit(const SpanSample& first, const SpanSample& middle, const SpanSample& last) noexcept {
  SpanMisfit result;
  const double length = last.s - first.s, after = middle.s - first.s;
  for (std::size_t i = 0; i < result.off.size(); ++i) {
    const bool turn = i >= SpanSample::kTurn;
    const SpanCurve::End &a = first.ends[i], &b = middle.ends[i], &c = last.ends[i];
    const SpanCurve whole = turn ? SpanCurve::of_slopes(a, c, length) : SpanCurve{a, c, length};
    const SpanCurve::Derivatives there = whole.at(after);
    result.off[i] = {turn ? 0.0 : std::fabs(whole.value(after) - b.value), std::fabs(there.first - b.slope),
                     std::fabs(there.second - b.bend)};
  }
  return result;
}

PathSpan span_between(const SpanSample& first, const SpanSample& last, const SpanMisfit& misfit) noexcept {
  PathSpan span{.from = first.s, .to = last.s};
  const double length = last.s - first.s, whole = 2.0 * length;
  for (std::size_t i = 0; i < span.curves.size(); ++i) {
    const bool turn = i >= SpanSample::kTurn;
    const SpanCurve::End &a = first.ends[i], &b = last.ends[i];
    span.curves[i] = turn ? SpanCurve::of_slopes(a, b, length) : SpanCurve{a, b, length};
    span.errors[i] = errors_of(misfit.off[i], whole, turn ? kOfSlopes : kOfValue);
  }
  return span;
}

}  // namespace armature
