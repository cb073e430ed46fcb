#include "controller/trajectory/sampler.hpp"

#include "controller/core/timebase.hpp"

namespace armature {
namespace {

double seconds(Ticks ticks) {
  return static_cast<double>(ticks.value()) * kTickSeconds;
}

}  // namespace

Sampler::Sampler(const RobotModel& robot, const PerAxis<Radians>& position) noexcept
    : robot_{robot}, position_{position} {}

void Sampler::hold(const PerAxis<Radians>& position) noexcept {
  position_ = position;
  moving_ = false;
  stop_.reset();
}

void Sampler::start(const JointPlan& plan) noexcept {
  plan_ = plan;
  elapsed_ = Ticks{0};
  stop_.reset();
  moving_ = plan.duration > Ticks{0};
}

void Sampler::stop() noexcept {
  if (moving_ && !stop_) stop_.emplace(plan_, robot_, seconds(elapsed_));
}

const PerAxis<Radians>& Sampler::advance() noexcept {
  if (!moving_) return position_;
  if (stop_) {
    position_ = armature::position(plan_, stop_->advance());
    moving_ = !stop_->finished();
  } else {
    elapsed_ += Ticks{1};
    position_ = armature::position(plan_, seconds(elapsed_));
    moving_ = elapsed_ < plan_.duration;
  }
  return position_;
}

}  // namespace armature
