// A correction from the network of the logic, or 0: one run per tick, whose result is used in the next one.
//
//   tick k      collect() the result of tick k - 1, then request() with the observation of tick k
//
// A result that does not come in time, or that the block does not vouch for, is a correction of 0 and is counted. The
// bound is in the hardware: no fault of this class exceeds it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "controller/drivers/policy_mlp.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/policy/policy_scale.hpp"

namespace armature {

class PolicyGuard {
 public:
  struct Counts {
    std::uint32_t used = 0;          // corrections from the network
    std::uint32_t late = 0;          // the run had not ended in the tick after its request
    std::uint32_t out_of_range = 0;  // an observation was outside the ranges of training: no request
    std::uint32_t invalid = 0;       // the image was corrupt or malformed
  };

  // `share`: the largest correction in 1/127 of PolicyScale::full_output, 0..127.
  PolicyGuard(RegisterBus& bus, const PolicyScale& scale, std::uint8_t share) noexcept
      : block_{bus}, scale_{scale}, share_{share} {}

  // Loads an image. False: the block is not present or not supported; every correction is then 0.
  bool start(std::span<const std::uint32_t> image, std::uint32_t crc) noexcept;
  // The same in parts, so that no tick is late: `words` more of it; true when all are loaded. Before that there is no
  // request.
  bool load(std::span<const std::uint32_t> image, std::uint32_t crc, std::size_t words) noexcept;

  void request(std::span<const double> observation) noexcept;
  // The correction of the last request; 0 without one.
  [[nodiscard]] PolicyScale::Correction collect() noexcept;

  [[nodiscard]] const Counts& counts() const noexcept { return counts_; }

 private:
  PolicyMlp block_;
  PolicyScale scale_;
  std::uint8_t share_;
  std::size_t loaded_ = 0;  // words
  bool begun_ = false, usable_ = false, requested_ = false, late_ = false;
  Counts counts_;
};

}  // namespace armature
