#include "controller/activity/conveyor/belt_correction.hpp"

#include <cstddef>
#include <utility>

namespace armature {

static_assert(BeltPolicyConfig::kWhole == PolicyScale::kFull);

PolicyScale scale_of(const BeltPolicyConfig& config) noexcept {
  PolicyScale scale{.input_count = config.inputs.size(), .output_count = 1};
  for (std::size_t i = 0; i < config.inputs.size(); ++i) {
    scale.inputs[i] = {.low = config.inputs[i].low, .high = config.inputs[i].high};
  }
  scale.full_output[0] = config.full_mm;
  return scale;
}

BeltCorrection::BeltCorrection(RegisterBus& bus, const BeltPolicyConfig& config) noexcept
    : bus_{bus}, config_{config}, scale_{scale_of(config)} {
  if (config_.where == BeltPolicyConfig::Where::kLogic) {
    guard_.emplace(bus_, scale_, config_.share);
    return;
  }
  network_ = PolicyNetwork::decode(image());
  if (network_ && PolicyNetwork::checksum(image().first(network_->words())) != config_.crc) network_.reset();
}

// True when all is loaded.
bool BeltCorrection::load() noexcept {
  if (guard_) return guard_->load(image(), config_.crc, kWordsPerTick);
  waited_words_ += kWordsPerTick;
  return waited_words_ >= config_.words;
}

double BeltCorrection::collect() noexcept {
  if (guard_) return guard_->collect()[0];
  if (!std::exchange(requested_, false)) return 0.0;
  if (!network_) {
    ++counts_.invalid;
    return 0.0;
  }
  ++counts_.used;
  return scale_.correction(*outputs_)[0];
}

void BeltCorrection::request(const BeltObservation::Values& observation) noexcept {
  if (!loaded_) {
    loaded_ = load();
    return;
  }
  if (guard_) return guard_->request(observation);
  const auto bytes = scale_.quantised(observation);
  if (!bytes) {
    ++counts_.out_of_range;
    return;
  }
  requested_ = true;
  if (!network_) return;
  bus_.charge(Work::kNetwork);
  outputs_ = network_->evaluate(std::span{*bytes}.first(scale_.input_count), config_.share);
}

}  // namespace armature
