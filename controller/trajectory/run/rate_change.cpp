#include "controller/trajectory/run/rate_change.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "controller/base/math.hpp"

namespace armature {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
// The part of the jerk that ends a change at least, although the plan needs all of it.
constexpr double kLeastShare = 0.02;
// Share of the jerk with which changes end, and by how much less in the last steps, of which this is the number: in
// whole steps the change of u differs by up to an eighth. What is left corrects differences from tick to tick.
constexpr double kEndShare = 0.9, kLastStepsLess = 0.1, kLastSteps = 20.0;
// The jerk with which a change may end where the plan needs all of it.
constexpr double kEndTolerance = 1.03;
// Shares of the jerk across the direction of the tool and along it while u decreases.
constexpr double kAcross = 0.8, kAlong = 0.55, kLeastAlong = 0.1;
// Share of the common w that a joint which turns round may rely on.
constexpr double kShared = 0.5;
// A joint with q''^2 above this many times J |q'| turns round: 2 and some rounding.
constexpr double kTurnsRound = 2.2;
// The end of a change is later than computed where the plan already needs jerk.
constexpr double kLater = 1.1, kLaterTicks = 4.0;
// Less than this share of the limit is no jerk of the plan, but the rounding error of a third difference.
constexpr double kLeastPlanJerk = 0.02;
// How much more than the w of the slowest joint may be needed later to keep the rate in 0..1: the plan may help.
constexpr double kMaxNeeded = 1.15;
// The largest w, for the first and last ticks of a plan, where the joints hardly move.
constexpr double kMaxChange = 0.04;
// In a bend the acceleration for the change stays below the limit by this share of that across the motion: near the
// limit a growing one would need a sudden change of u.
constexpr double kBendReserve = 0.3;

}  // namespace

RateChange::RateChange(double rate, double rate_step, double wanted, RateJerk jerk) noexcept
    : rate_{rate},
      step_{rate_step},
      wanted_{wanted},
      kept_{rate + rate_step},
      left_{std::fabs(wanted - rate)},
      sign_{wanted < rate ? -1.0 : 1.0},
      jerk_{-kInfinite, kInfinite},
      accel_{-kInfinite, kInfinite},
      most_step_{left_},
      slowest_{kInfinite},
      kind_{jerk} {
  ends_[count_++] = {.quickest = kMaxChange};
}

void RateChange::Range::cut(double from, double to) noexcept {
  low = std::max(low, from);
  high = std::min(high, to);
}

double RateChange::Range::nearest(double value) const noexcept {
  return low <= high ? std::clamp(value, low, high) : std::clamp(value, high, low);
}

void RateChange::add(const Motion<double>& joint) noexcept {
  const double plan_jerk = std::fabs(joint.change - 3.0 * joint.accel * rate_ * step_);
  const double jerk = std::max(joint.max_change, plan_jerk), most_bend = joint.max_bend;
  if (joint.speed != 0.0) {
    const double jerk_middle = -joint.change / joint.speed, jerk_half = std::fabs(jerk / joint.speed);
    const double bend_middle = -joint.bend / joint.speed, bend_half = std::fabs(most_bend / joint.speed);
    cut_jerk(jerk_middle, jerk_half);
    accel_.cut(bend_middle - bend_half, bend_middle + bend_half);
  }
  if (kind_ != RateJerk::kMonotonic)
    turns_[turn_count_++] = {std::fabs(joint.speed), std::fabs(joint.accel), jerk, plan_jerk};
  if (joint_move() && joint.speed != 0.0) {
    // The jerk of the plan in the direction in which the change accelerates the joint.
    const double outwards = joint.speed > 0.0 ? sign_ : -sign_;
    const double plan = (joint.change - 3.0 * joint.accel * rate_ * step_) * outwards;
    if (joint.accel * joint.speed < 0.0) limit_step(std::max(jerk + plan, 0.0), joint.accel);
    if (plan > kLeastPlanJerk * jerk) {
      const double later = joint.accel * outwards > 0.0 ? joint.peak * rate_ * rate_ : 0.0;
      most_step_ = std::min(most_step_, std::max(most_bend - later, 0.0) / std::fabs(joint.speed));
    }
  }
  const double square = joint.accel * joint.accel;
  // The path that is left to a standstill is about 2 r^2 / 3 |u|. A joint that turns round after that ends here as
  // others.
  const bool stops_before =
      wanted_ == 0.0 && step_ < 0.0 && 2.0 * rate_ * rate_ * std::fabs(joint.accel) < std::fabs(step_ * joint.speed);
  if (!stops_before && square > kTurnsRound * jerk * std::fabs(joint.speed) + 10.0 * jerk * jerk) {
    limit_step(jerk - plan_jerk, joint.accel);
  } else {
    end(joint.speed, joint.accel, jerk);
  }
}

void RateChange::add(const Motion<Eigen::Vector3d>& tool) noexcept {
  const double speed2 = tool.speed.squaredNorm();
  if (!(speed2 > 0.0)) return;
  const Eigen::Vector3d plan_jerk = tool.change - 3.0 * rate_ * step_ * tool.accel;
  const double jerk = std::max(tool.max_change, plan_jerk.norm());
  const double speed = std::sqrt(speed2);
  const Eigen::Vector3d direction = tool.speed / speed;
  const auto across = [&](const Eigen::Vector3d& v) { return (v - v.dot(direction) * direction).norm(); };
  // What |kept + speed w| <= most leaves for a component in the direction.
  const auto left = [&](const Eigen::Vector3d& kept, double most) {
    const double rest = across(kept);
    return std::sqrt(std::max(most * most - rest * rest, 0.0));
  };
  const double jerk_along = left(tool.change, jerk), bend_along = left(tool.bend, tool.max_bend);
  cut_jerk(-tool.change.dot(direction) / speed, jerk_along / speed);
  const double bend_middle = -tool.bend.dot(direction) / speed;
  accel_.cut(bend_middle - bend_along / speed, bend_middle + bend_along / speed);

  const double least_along = std::max(kAlong * jerk - std::fabs(plan_jerk.dot(direction)), kLeastAlong * jerk);
  const double accel_across = across(tool.accel), accel = tool.accel.dot(direction);
  limit_across(kAcross * (jerk - across(plan_jerk)), accel_across, least_along / speed);
  const double plan_across = accel_across * rate_ * rate_, most = tool.max_bend - kBendReserve * plan_across;
  const double most_along = std::sqrt(std::max(most * most - plan_across * plan_across, 0.0));
  most_step_ = std::min(most_step_, std::max(most_along - sign_ * accel * rate_ * rate_, 0.0) / speed);
  end(speed, accel, jerk_along);
}

void RateChange::cut_jerk(double middle, double half) noexcept {
  const double against = kEndTolerance * half;
  jerk_.cut(middle - (step_ > 0.0 ? against : half), middle + (step_ < 0.0 ? against : half));
}

// While u decreases by `w` in each tick, u^2 + 2 w r is constant, and r u is largest where it is 3 w r. There the jerk
// 3 q'' r u across the motion must be in its limit.
void RateChange::limit_across(double jerk, double accel, double w) noexcept {
  if (accel == 0.0) return;
  const double peak = math::cbrt(std::sqrt(3.0) * jerk * w / accel), most = peak * peak;
  if (sign_ > 0.0 && rate_ < most / (3.0 * w)) {
    most_step_ = std::min(most_step_, std::sqrt(std::max(most - 2.0 * w * rate_, 0.0)));
  } else {
    limit_step(jerk, accel);
  }
}

void RateChange::limit_step(double jerk_left, double accel) noexcept {
  const double by_step = 3.0 * std::fabs(accel) * rate_;
  if (by_step * most_step_ > jerk_left) most_step_ = jerk_left / by_step;
}

void RateChange::end(double speed, double accel, double jerk) noexcept {
  if (speed == 0.0) return;
  ends_[count_] = {.quickest = std::min(jerk / std::fabs(speed), kMaxChange), .growth = accel / speed};
  slowest_ = std::min(slowest_, ends_[count_].quickest);
  ++count_;
}

// Speeds up to a peak of u, and slows down from there.
double RateChange::ahead() const noexcept {
  if (!(slowest_ < kInfinite) || left_ == 0.0) return 0.0;
  const double step = std::max(sign_ * step_, 0.0), w = slowest_;
  const double peak = std::sqrt(w * left_ + 0.5 * step * step);
  const double ticks = peak > step ? (2.0 * peak - step) / w : 2.0 * left_ / step;
  return (kLater * ticks + kLaterTicks) * std::max(wanted_, (rate_ + 2.0 * wanted_) / 3.0);
}

// Steps of n w, (n - 1) w, .. w change the rate by n (n + 1) / 2 w.
double RateChange::step_to_end(const End& end, double wanted, double share) const noexcept {
  const double decay = std::max(-end.growth * std::fabs(step_) * wanted, 0.0);
  const double left = std::fabs(wanted - rate_);
  const double last = kLastStepsLess / (1.0 + left / (kLastSteps * end.quickest));
  const double w = std::max((share - last) * end.quickest - decay, kLeastShare * end.quickest);
  const double most = left <= w ? left : 0.5 * w * (std::sqrt(1.0 + 8.0 * left / w) - 1.0);
  return std::max(most + end.growth * rate_ * left, 0.0);
}

double RateChange::needed_to_stop(double rate, double step) noexcept {
  if (step == 0.0) return 0.0;
  const double size = std::fabs(step), left = std::max(step > 0.0 ? 1.0 - rate : rate, 0.0);
  return size * size / (2.0 * left + size);
}

double RateChange::enough_to_stop(double change) const noexcept {
  const double next = step_ + change, needed = needed_to_stop(rate_, step_);
  if (needed_to_stop(rate_ + next, next) <= std::max(needed, kMaxNeeded * slowest_)) return change;
  return step_ > 0.0 ? -needed : needed;
}

double RateChange::rate(double plan_jerk) noexcept {
  const double mean = wanted_ * (rate_ * rate_ + rate_ * wanted_ + wanted_ * wanted_) / 3.0;
  const double share = std::max(kEndShare - plan_jerk * mean, 0.0);
  double step = most_step_;
  for (std::size_t i = 0; i < count_; ++i) {
    if (joint_move()) ends_[i].quickest = std::min(ends_[i].quickest, slowest_);
    step = std::min(step, step_to_end(ends_[i], wanted_, share));
    // The rate must not have to go below 0 either.
    if (sign_ < 0.0 && wanted_ > 0.0) step = std::min(step, step_to_end(ends_[i], 0.0, kEndShare));
  }
  // A joint that may turn round: its own jerk and half of the w that every joint can add must be enough.
  for (std::size_t i = 0; i < turn_count_; ++i) {
    const Turn& turn = turns_[i];
    const double jerk = turn.jerk + kShared * slowest_ * turn.speed, by_step = 3.0 * turn.accel * rate_;
    if (by_step * step > jerk - turn.plan_jerk) step = std::max(jerk - turn.plan_jerk, 0.0) / by_step;
  }
  step *= sign_;
  // Where two motions contradict each other, u goes to 0.
  const double to_zero = std::clamp(-step_, -slowest_, slowest_);
  const double change = accel_.nearest(jerk_.nearest(jerk_.empty() ? to_zero : step - step_));
  const double allowed = enough_to_stop(std::clamp(change, -kMaxChange, kMaxChange));
  if (step_ + allowed == step && std::fabs(step) == left_) return wanted_;
  return std::clamp(rate_ + step_ + allowed, 0.0, 1.0);
}

}  // namespace armature
