// The time at which the drives can be switched on: the arm must have come to rest, and must have stood for 5 ms.
#pragma once

#include <utility>

#include "controller/base/timebase.hpp"
#include "controller/base/units.hpp"
#include "controller/message/fault.hpp"

namespace armature::pendant {

inline constexpr Cycles kMillisecond{kClkFreqHz / 1'000};

class DrivesDelay {
 public:
  void on_fault(FaultCause cause) noexcept { delay_ = cause == FaultCause::kDrivesOff ? kStandstill : kSettling; }
  // Call at the start of each execute(): a fault that has just come begins now.
  void update(Cycles now) noexcept {
    if (delay_ > Cycles{0}) earliest_ = now + std::exchange(delay_, Cycles{0});
  }

  // The drives are to be switched on as soon as possible.
  void request() noexcept { requested_ = true; }
  void cancel() noexcept { requested_ = false; }
  [[nodiscard]] bool requested() const noexcept { return requested_; }
  // True once, when they can be.
  [[nodiscard]] bool take_due(Cycles now) noexcept {
    return requested_ && now >= earliest_ && std::exchange(requested_, false);
  }

 private:
  // After an alarm the arm still moves.
  static constexpr Cycles kStandstill{6 * kMillisecond.value()}, kSettling{50 * kMillisecond.value()};

  Cycles delay_{};  // of a fault that has just come
  Cycles earliest_{};
  bool requested_ = false;
};

}  // namespace armature::pendant
