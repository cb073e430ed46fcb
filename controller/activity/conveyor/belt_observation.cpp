#include "controller/activity/conveyor/belt_observation.hpp"

#include "controller/base/timebase.hpp"

namespace armature {

static_assert(BeltObservation::kMean_s.size() + 2 == BeltPolicyConfig::kInputs);

BeltObservation::BeltObservation(const std::optional<BeltCamera>& camera) noexcept
    : sample_s_{camera ? seconds(camera->period) : kTickSeconds} {
  if (camera) longer_ = sample_s_ / kMean_s.front();
}

void BeltObservation::add(const ConveyorBelt& belt) noexcept {
  for (std::size_t i = 0; i < kMean_s.size(); ++i) {
    const double gain = sample_s_ / (longer_ * kMean_s[i] + sample_s_);
    values_[i] += gain * (belt.error_mm() - values_[i]);
  }
  values_[kMean_s.size()] = belt.accel_mm_s2();
  values_[kMean_s.size() + 1] = belt.velocity_mm_s();
}

}  // namespace armature
