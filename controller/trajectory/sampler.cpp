#include "controller/trajectory/sampler.hpp"

#include <variant>

#include "controller/core/timebase.hpp"

namespace armature {
namespace {

// Braking together with the plan's own braking ends a rounding before the plan does. That is the end: what is missing
// is less than a_max (kEndTicks Ts)^2 / 2, a millionth of what a tick may change.
constexpr double kEndTicks = 1e-3;

}  // namespace

Sampler::Sampler(const RobotModel& robot, const Arm& arm, const PerAxis<Radians>& position) noexcept
    : arm_{arm}, position_{position}, clock_{robot} {}

void Sampler::stand_at(const PerAxis<Radians>& position) noexcept {
  position_ = position;
  busy_ = false;
  rate_ = 0.0;
}

void Sampler::start(const MotionPlan& plan, double rate) noexcept {
  plan_ = plan;
  duration_ = duration(plan_);
  clock_.restart(rate);
  busy_ = duration_ > Ticks{0};
}

const PerAxis<Radians>& Sampler::advance(double rate) noexcept {
  inverses_ = 0;
  rate_ = 0.0;
  if (!busy_) return position_;
  position_ = clock_.advance(rate, position_, [this](double ticks) { return at(ticks); });
  rate_ = clock_.rate();
  busy_ = clock_.time() < static_cast<double>(duration_.value()) - kEndTicks;
  if (!busy_) position_ = target_of(plan_);
  return position_;
}

PerAxis<Radians> Sampler::at(double ticks) noexcept {
  const double t_s = ticks * kTickSeconds;
  if (const auto* cartesian = std::get_if<CartesianPlan>(&plan_)) {
    ++inverses_;
    return armature::position(*cartesian, arm_, t_s, position_);
  }
  return armature::position(*std::get_if<JointPlan>(&plan_), t_s);
}

}  // namespace armature
