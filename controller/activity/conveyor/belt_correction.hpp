// A network corrects where the belt is expected, within a bound: in the logic, or by software with the same bits.
//
// The correction of a tick is that of the observation of the tick before. There is none (0) outside the ranges of
// training, if the image of the network is not the one of its checksum, and if the logic is late; each is counted. The
// logic gets kWordsPerTick words of the image in each of the first ticks; software waits as long.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "controller/activity/conveyor/belt_observation.hpp"
#include "controller/cell/belt_policy_config.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/policy/policy_guard.hpp"
#include "controller/policy/policy_network.hpp"
#include "controller/policy/policy_scale.hpp"

namespace armature {

// Between the numbers of a belt and the bytes of its network.
[[nodiscard]] PolicyScale scale_of(const BeltPolicyConfig& config) noexcept;

class BeltCorrection {
 public:
  // Both must outlive the object.
  BeltCorrection(RegisterBus& bus, const BeltPolicyConfig& config) noexcept;

  static constexpr std::size_t kWordsPerTick = 8;

  // Once in each tick, before the belt is sampled: in mm.
  [[nodiscard]] double collect() noexcept;
  // Then, when it is sampled.
  void request(const BeltObservation::Values& observation) noexcept;

  [[nodiscard]] const PolicyGuard::Counts& counts() const noexcept { return guard_ ? guard_->counts() : counts_; }

 private:
  [[nodiscard]] bool load() noexcept;
  [[nodiscard]] std::span<const std::uint32_t> image() const noexcept {
    return std::span{config_.image}.first(config_.words);
  }

  RegisterBus& bus_;
  const BeltPolicyConfig& config_;
  PolicyScale scale_;
  bool loaded_ = false;
  std::size_t waited_words_ = 0;
  // In the logic.
  std::optional<PolicyGuard> guard_{};
  // In software.
  std::optional<PolicyNetwork> network_{};
  std::optional<PolicyNetwork::Outputs> outputs_{};  // of the last request
  bool requested_ = false;
  PolicyGuard::Counts counts_{};
};

}  // namespace armature
