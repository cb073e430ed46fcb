// Belts with changing speed and targets of a hand, what a network sees of them, and what it should answer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "controller/activity/conveyor/belt_observation.hpp"
#include "controller/activity/conveyor/conveyor_belt.hpp"
#include "cosim/belt/conveyor_spec.hpp"

namespace armature::cosim {

// What the network is for.
struct BeltTask {
  double mm_per_count = 0.05;
  double lead_ms = 5.305;  // of the drives
  double full_mm = 0.25;   // the largest correction
  // A target that a hand moves to and fro, instead of a belt with an encoder.
  std::optional<BeltCameraSpec> camera{};
};

// Those of the controller.
[[nodiscard]] ConveyorBelt::Bandwidths bandwidths_of(const BeltTask& task);

struct BeltExample {
  BeltObservation::Values inputs{};
  double correction_mm = 0;
};

// Of `belts` belts of a second, or targets of 3 s, drawn with `seed`. The answer is the correction with which the
// expected belt would be the one that really comes: it needs the future, so the network learns the mean of it that the
// past allows.
[[nodiscard]] std::vector<BeltExample> belt_examples(std::uint64_t seed, std::size_t belts, const BeltTask& task);

// How far the expected belt is from the one that comes.
struct BeltErrors {
  double rms_mm = 0, worst_mm = 0;
  double unrest_mm_s2 = 0;  // rms of its acceleration while the belt has a constant speed: what the joints have to do
};
using BeltAnswer = std::function<double(const BeltObservation::Values&)>;  // mm

// Of belts with other seeds than those of training. `answer`: empty without a network.
[[nodiscard]] BeltErrors belt_errors(std::uint64_t seed, std::size_t belts, const BeltTask& task,
                                     const ConveyorBelt::Bandwidths& bandwidths, const BeltAnswer& answer);

}  // namespace armature::cosim
