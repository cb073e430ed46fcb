// Trains the network of [conveyor.policy].
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "controller/cell/belt_policy_config.hpp"
#include "cosim/train/belt_examples.hpp"

namespace armature::cosim {

struct BeltTraining {
  BeltTask task{};
  std::uint64_t seed = 1;
  std::size_t belts = 100;  // >= 1
  std::size_t epochs = 6;   // >= 1
};

struct TrainedBelt {
  BeltPolicyConfig network{};
  std::size_t examples = 0;
  std::string examples_sha256;  // of their numbers
  double wanted_rms_mm = 0;     // of the corrections that the examples want
  double left_rms_mm = 0;       // what the network of doubles leaves of them
  double left_int8_rms_mm = 0;  // the same of the network of integers
};

// The same bytes on every machine.
[[nodiscard]] TrainedBelt train_belt(const BeltTraining& training);

// The answer of a network, as BeltCorrection computes it.
[[nodiscard]] BeltAnswer answer_of(const BeltPolicyConfig& network);

// The file of the network; `command`: what makes it.
[[nodiscard]] std::string policy_text(const TrainedBelt& trained, const std::string& command);

}  // namespace armature::cosim
