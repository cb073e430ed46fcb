#include "controller/policy/policy_scale.hpp"

#include <cmath>

namespace armature {

std::optional<PolicyScale::Bytes> PolicyScale::quantised(std::span<const double> observation) const noexcept {
  if (observation.size() < input_count || input_count > inputs.size()) return std::nullopt;
  Bytes bytes{};
  for (std::size_t i = 0; i < input_count; ++i) {
    const auto& [low, high] = inputs[i];
    const double value = observation[i];
    if (!(value >= low && value <= high)) return std::nullopt;  // also if it is not a number
    const double centred = (value - (low + high) / 2) / ((high - low) / 2) * kFull;
    const double magnitude = std::floor(std::fabs(centred) + 0.5);
    bytes[i] = static_cast<std::int8_t>(std::fmin(magnitude, kFull) * (centred < 0 ? -1 : 1));
  }
  return bytes;
}

PolicyScale::Correction PolicyScale::correction(
    const std::array<std::int8_t, PolicyMlp::kOutputs>& outputs) const noexcept {
  Correction correction{};
  for (std::size_t i = 0; i < output_count && i < correction.size(); ++i) {
    correction[i] = outputs[i] / kFull * full_output[i];
  }
  return correction;
}

}  // namespace armature
