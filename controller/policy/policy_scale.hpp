// From measured values to the signed bytes of a network, and back.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "controller/drivers/policy_mlp.hpp"

namespace armature {

// The ranges of training. The units are those of the observation and of the correction.
struct PolicyScale {
  static constexpr double kFull = 127;  // the largest magnitude of a byte
  struct Range {
    double low = 0, high = 0;  // of an input; low < high
  };
  std::array<Range, PolicyMlp::kInputs> inputs{};
  std::size_t input_count = 0;
  // What an output of kFull means; output_count of them.
  std::array<double, PolicyMlp::kOutputs> full_output{};
  std::size_t output_count = 0;

  using Bytes = std::array<std::int8_t, PolicyMlp::kInputs>;
  // The bytes -127..127 of low..high, to nearest, halves away from 0. None: a value is missing, not finite or outside
  // its range.
  [[nodiscard]] std::optional<Bytes> quantised(std::span<const double> observation) const noexcept;

  using Correction = std::array<double, PolicyMlp::kOutputs>;
  [[nodiscard]] Correction correction(const std::array<std::int8_t, PolicyMlp::kOutputs>& outputs) const noexcept;
};

}  // namespace armature
