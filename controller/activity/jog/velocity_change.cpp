#include "controller/activity/jog/velocity_change.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "controller/base/halving.hpp"
#include "controller/trajectory/state/axis_reach.hpp"

namespace armature {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();
// The time in which the acceleration turns is found to this share of its upper bound, in powers of 1/2.
constexpr int kChangeBisections = 40;

// The largest x >= 0 with x |part| <= limit.
double most_of(double limit, double part) {
  return part == 0.0 ? kNoLimit : limit / std::fabs(part);
}

// 0: not limited.
double larger_limit(double one, double other) {
  return one == 0.0 || other == 0.0 ? 0.0 : std::max(one, other);
}

}  // namespace

void VelocityChange::keep(const Twist& velocity) noexcept {
  from_ = end_ = turned_ = velocity;
  turn_s_ = 0.0;
  direction_ = Twist::Zero();
  law_ = PhaseLaw{};
}

bool VelocityChange::plan(double t_s, const Twist& velocity, const Change& accel, const Change& way,
                          const Limits& limits) noexcept {
  begin(t_s, velocity, accel, way, limits);
  return finish();
}

void VelocityChange::begin(double t_s, const Twist& velocity, const Change& accel, const Change& way,
                           const Limits& limits) noexcept {
  const Jerk before = t_s < turn_s_ ? turning_ : Jerk{limits_.jerk_mm_s3, limits_.turn_jerk_rad_s3};
  turning_ = {larger_limit(before.move, limits.jerk_mm_s3), larger_limit(before.turn, limits.turn_jerk_rad_s3)};
  limits_ = limits;
  accel_ = accel;
  way_ = way;
  from_ = velocity;
  end_ = velocity + way.twist;
  accel_per_jerk_ = per_jerk(accel_.twist);
  // A short time in which a jerk within the limits makes the acceleration one along the rest of the change. In this
  // one it can become 0.
  turn_s_ = accel_per_jerk_.norm();
  if (turn_s_ > 0.0) {
    const EndValues at{.inside = std::min(turns_beyond(turn_s_), 0.0), .outside = turns_beyond(0.0)};
    turn_s_ = halved<kChangeBisections>({.inside = turn_s_, .outside = 0.0}, at, [this](double tried_s) {
                return turns_beyond(tried_s);
              }).inside;
  }
}

bool VelocityChange::finish() noexcept {
  const Direction left = left_after(turn_s_);
  const double turned = turned_accel(left, turn_s_), speed = most_accel(left);
  if (!(speed > 0.0 && speed < kNoLimit)) return false;
  direction_ = left.change.twist;
  accel_change_ = turned * direction_ - accel_.twist;
  turned_ = from_ + turn_s_ * (accel_.twist + 0.5 * accel_change_);
  // The speed and the acceleration of the law are an acceleration and a jerk.
  law_ = plan_to_rest(ProfileKind::kTrapezoid, {.velocity = turned}, 1.0 - 0.5 * turned * turn_s_,
                      {.speed = speed, .accel = std::min(most_jerk(left), speed / limits_.tick_s)});
  return true;
}

VelocityChange::Twist VelocityChange::at(double t_s) const noexcept {
  if (t_s < turn_s_) return from_ + t_s * (accel_.twist + (0.5 * t_s / turn_s_) * accel_change_);
  const double along_s = t_s - turn_s_;
  if (along_s >= law_.duration_s()) return end_;
  return turned_ + law_.at(along_s).position * direction_;
}

// What is left of the way after the acceleration has turned for this time, but for a part along the result: so whatever
// acceleration of this direction it then is.
VelocityChange::Direction VelocityChange::left_after(double turn_s) const noexcept {
  Direction left{.change = {.twist = way_.twist - 0.5 * turn_s * accel_.twist}};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    left.change.joints_rad_s[axis] = way_.joints_rad_s[axis] - 0.5 * turn_s * accel_.joints_rad_s[axis];
  }
  left.move_mm_s = left.change.twist.head<3>().norm();
  left.turn_rad_s = left.change.twist.tail<3>().norm();
  return left;
}

// The acceleration along `left` to which the present one turns in this time, as a multiple of `left`. It is the nearest
// one within the limits from which the velocity does not go beyond its end.
double VelocityChange::turned_accel(const Direction& left, double turn_s) const noexcept {
  const Twist scaled = per_jerk(left.change.twist);
  const double square = scaled.squaredNorm();
  if (!(square > 0.0)) return 0.0;
  const double nearest = scaled.dot(accel_per_jerk_) / square;
  // x^2 = 2 jerk (1 - x turn_s / 2)
  const double jerk = most_jerk(left), half = 0.5 * jerk * turn_s;
  const double most = jerk < kNoLimit ? std::sqrt(half * half + 2.0 * jerk) - half : kNoLimit;
  return std::clamp(nearest, 0.0, std::min(most, most_accel(left)));
}

// The time by which the acceleration needs longer than this to turn along what is left then.
double VelocityChange::turns_beyond(double turn_s) const noexcept {
  const Direction left = left_after(turn_s);
  const Twist change = turned_accel(left, turn_s) * left.change.twist - accel_.twist;
  return per_jerk(change).norm() - turn_s;
}

// The time that this change of the acceleration takes while it turns, as a vector. Its length is at least the time that
// each of both parts takes.
VelocityChange::Twist VelocityChange::per_jerk(const Twist& change) const noexcept {
  Twist scaled;
  for (Eigen::Index i = 0; i < 3; ++i) {
    scaled[i] = turning_.move > 0.0 ? change[i] / turning_.move : 0.0;
    scaled[i + 3] = turning_.turn > 0.0 ? change[i + 3] / turning_.turn : 0.0;
  }
  return scaled;
}

// The largest multiple of `direction` that is an acceleration within the limits.
double VelocityChange::most_accel(const Direction& direction) const noexcept {
  double most = std::min(most_of(limits_.accel_mm_s2, direction.move_mm_s),
                         most_of(limits_.turn_accel_rad_s2, direction.turn_rad_s));
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    most = std::min(most, most_of(limits_.joint_accel_rad_s2[axis], direction.change.joints_rad_s[axis]));
  }
  return most;
}

double VelocityChange::most_jerk(const Direction& direction) const noexcept {
  double most = kNoLimit;
  if (limits_.jerk_mm_s3 > 0.0) most = std::min(most, most_of(limits_.jerk_mm_s3, direction.move_mm_s));
  if (limits_.turn_jerk_rad_s3 > 0.0) {
    most = std::min(most, most_of(limits_.turn_jerk_rad_s3, direction.turn_rad_s));
  }
  return most;
}

}  // namespace armature
