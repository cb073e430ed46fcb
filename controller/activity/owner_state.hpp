// What core 0 has reported about the arm: what moves it, and its fault.
//
// It changes with the events, so all clients of core 1 see it in step with them. ArmOwner itself is ahead of it: it
// knows what was sent to core 0, and the answers of core 0.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/message/event.hpp"

namespace armature {

class OwnerState {
 public:
  void on_event(const Event& event) noexcept;

  // A jog has started.
  [[nodiscard]] bool jogs() const noexcept { return jogs_; }
  // A move has started, or an axis is being homed.
  [[nodiscard]] bool moves() const noexcept { return moves_ > 0 || homing_ != 0; }
  // The fault that was not cleared yet; of a controller whose drives are off it is kDrivesOff.
  [[nodiscard]] const std::optional<Faulted>& fault() const noexcept { return fault_; }

  // `axes` without the one that has ended. A failed axis ends the homing of all: bit 0 for axis 1.
  [[nodiscard]] static constexpr std::uint8_t axes_after(const HomingEnded& end, std::uint8_t axes) noexcept {
    return end.how == HomingEnd::kHomed ? static_cast<std::uint8_t>(axes & ~(1U << (end.axis - 1U))) : std::uint8_t{0};
  }

 private:
  bool jogs_ = false;
  std::int32_t moves_ = 0;
  std::uint8_t homing_ = 0;  // axes that are being homed
  std::optional<Faulted> fault_{};
};

}  // namespace armature
