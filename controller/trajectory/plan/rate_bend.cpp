#include "controller/trajectory/plan/rate_bend.hpp"

#include <algorithm>
#include <cmath>

#include "controller/core/timebase.hpp"

namespace armature {

double rate_bend(double speed, double jerk, double accel) noexcept {
  constexpr double kShare = 0.4;
  double w = speed > 0.0 ? jerk / speed : kAnyBend;
  if (accel > 0.0) w = std::min(w, jerk / accel * (jerk / accel));
  return std::max(kMinBend, kShare * w * kTickSeconds * kTickSeconds);
}

double rate_bend(const JointPlan& plan, const RobotModel& robot) noexcept {
  double least = kAnyBend;
  for (std::size_t axis = 0; axis < robot.axis_count; ++axis) {
    const TimeLaw& law = plan.profiles[axis];
    if (law.kind != ProfileKind::kSCurve || law.peak_speed() == 0.0) continue;
    least = std::min(least, rate_bend(law.peak_speed(), robot.axes[axis].max_jerk_rad_s3));
  }
  return least;
}

double rate_bend(const RetargetPlan& plan, const RobotModel& robot) noexcept {
  if (plan.kind != ProfileKind::kSCurve) return kAnyBend;
  double least = kAnyBend;
  for (std::size_t axis = 0; axis < robot.axis_count; ++axis) {
    const PhaseLaw& law = plan.laws[axis];
    const double jerk = robot.axes[axis].max_jerk_rad_s3;
    least = std::min(least, rate_bend(law.peak_speed(), jerk, law.peak_accel()));
  }
  return least;
}

double rate_bend(const JointChain& plan, const RobotModel& robot) noexcept {
  double least = kAnyBend;
  for (std::size_t move = 0; move < plan.count; ++move) least = std::min(least, rate_bend(plan.moves[move], robot));
  return least;
}

double rate_bend(const MotionPlan& plan, const RobotModel& robot) noexcept {
  double least = kAnyBend;
  for (std::size_t i = 0; i < plan.parts(); ++i) {
    const MotionPlan::Part part = plan.part(i);
    if (part.chain != nullptr) least = std::min(least, rate_bend(*part.chain, robot));
    const std::size_t segments = part.path != nullptr ? part.path->count : 0;
    for (std::size_t k = 0; k < segments; ++k) least = std::min(least, part.path->segments[k].rate_bend);
  }
  return least;
}

PlanRun run_at(const CartesianPlan& plan, double ticks) noexcept {
  PlanRun run;
  std::int64_t end = 0;
  for (std::size_t i = 0; i < plan.count; ++i) {
    const CartesianSegment& segment = plan.segments[i];
    if (segment.start.value() >= end) {  // the tool rests
      if (i > 0 && ticks < run.end_ticks) break;
      run = {};
    }
    run.rate_bend = std::min(run.rate_bend, segment.rate_bend);
    end = std::max(end, end_of(segment).value());
    run.end_ticks = static_cast<double>(end);
  }
  return run;
}

void BendMeter::begin() noexcept {
  oldest_ = 0;
  peaks_.fill({});
}

void BendMeter::add(const CartesianPlan& plan, std::int64_t tick, const PerAxis<double>& steps_rad,
                    const PerAxis<double>& bends_rad, double move_mm, double turn_rad) noexcept {
  while (oldest_ + 1 < plan.count && end_of(plan.segments[oldest_]).value() < tick - 1) ++oldest_;
  std::size_t newest = oldest_;
  // A second difference contains two steps. If a trapezoid is part of it, it does not describe an S-curve.
  bool is_of_s_curves = true;
  for (std::size_t i = oldest_; i < plan.count && plan.segments[i].start.value() < tick; newest = i++) {
    is_of_s_curves = is_of_s_curves && plan.segments[i].profile == ProfileKind::kSCurve;
  }
  for (std::size_t i = oldest_; i <= newest; ++i) {
    if (end_of(plan.segments[i]).value() < tick) continue;
    peaks_[i].move_mm = std::max(peaks_[i].move_mm, move_mm);
    peaks_[i].turn_rad = std::max(peaks_[i].turn_rad, turn_rad);
    for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) {
      double &step_rad = peaks_[i].step_rad[axis], &bend_rad = peaks_[i].bend_rad[axis];
      step_rad = std::max(step_rad, std::fabs(steps_rad[axis]));
      if (is_of_s_curves) bend_rad = std::max(bend_rad, std::fabs(bends_rad[axis]));
    }
  }
}

void BendMeter::store(CartesianPlan& plan) const noexcept {
  for (std::size_t i = 0; i < plan.count; ++i) {
    CartesianSegment& segment = plan.segments[i];
    segment.rate_bend = kAnyBend;
    if (segment.profile != ProfileKind::kSCurve) continue;
    double least = std::min(rate_bend(peaks_[i].move_mm / kTickSeconds, segment.limits.jerk_mm_s3),
                            rate_bend(peaks_[i].turn_rad / kTickSeconds, segment.limits.turn_jerk_rad_s3));
    for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) {
      const double jerk_rad_s3 = robot_.axes[axis].max_jerk_rad_s3;
      if (!(jerk_rad_s3 > 0.0)) continue;  // unknown
      least = std::min(least, rate_bend(peaks_[i].step_rad[axis] / kTickSeconds, jerk_rad_s3,
                                        peaks_[i].bend_rad[axis] / (kTickSeconds * kTickSeconds)));
    }
    segment.rate_bend = least;
  }
}

}  // namespace armature
