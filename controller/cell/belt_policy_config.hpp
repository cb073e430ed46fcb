// The network that corrects where a belt is expected, as the host gives it to the controller.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/base/members.hpp"
#include "controller/base/misfit.hpp"

namespace armature {

struct BeltPolicyConfig {
  enum class Where : std::uint8_t {
    kLogic,  // the block policy_mlp
    kArm,    // software of core 0, with the same bits
  };
  static constexpr std::uint8_t kWhole = 127;  // the share that is all of the correction
  static constexpr std::size_t kInputs = 10;
  static constexpr std::size_t kMaxWords = 256;
  // Of an input in training; outside of it there is no correction.
  struct Range {
    double low = -1.0;
    double high = 1.0;  // > low

    [[nodiscard]] const void* misfit() const noexcept {
      return first_misfit({{&low, is_finite(low)}, {&high, is_finite(high) && high > low}});
    }
    ARMATURE_MEMBERS(Range, low, high)
  };

  Where where = Where::kLogic;
  std::array<Range, kInputs> inputs{};  // in the order of BeltObservation
  double full_mm = 0.0;                 // > 0; what an output of kWhole means
  std::uint8_t share = kWhole;          // the largest correction, in 1/kWhole of full_mm; 0 .. kWhole
  std::uint32_t crc = 0;                // of the image
  std::uint32_t words = 0;              // of the image, 1 .. kMaxWords
  std::array<std::uint32_t, kMaxWords> image{};

  [[nodiscard]] const void* misfit() const noexcept {
    return first_misfit(
        {{&full_mm, is_positive(full_mm)}, {&share, share <= kWhole}, {&words, words >= 1 && words <= kMaxWords}});
  }
  ARMATURE_MEMBERS(BeltPolicyConfig, where, inputs, full_mm, share, crc, words, image)
};

}  // namespace armature
