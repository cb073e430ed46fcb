// What a network sees of a belt: how well its observer predicts it.
//
// Whatever the network answers does not change what the observer sees. So a network may be trained on recorded belts.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "controller/activity/conveyor/conveyor_belt.hpp"
#include "controller/base/units.hpp"
#include "controller/cell/belt_policy_config.hpp"
#include "controller/cell/conveyor_config.hpp"

namespace armature {

class BeltObservation {
 public:
  // Means of the error of the prediction over the times kMean_s, in mm; the estimated acceleration in mm/s^2 and
  // velocity in mm/s. With a camera the times are longer: the shortest one is its period.
  using Values = std::array<double, BeltPolicyConfig::kInputs>;
  static constexpr std::array kMean_s{0.0005, 0.001, 0.002, 0.003, 0.0045, 0.007, 0.011, 0.018};

  explicit BeltObservation(const std::optional<BeltCamera>& camera = {}) noexcept;

  // After each sample of the belt.
  void add(const ConveyorBelt& belt) noexcept;
  [[nodiscard]] const Values& values() const noexcept { return values_; }

 private:
  double sample_s_;      // from sample to sample
  double longer_ = 1.0;  // factor of kMean_s
  Values values_{};
};

}  // namespace armature
