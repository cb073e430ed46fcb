// The interrupt controller and the global timer of the MPCore, as one core sees them: as much as the firmware uses
// (controller/board). What waits, wakes and counts time is the simulated core behind RegisterBus.
#pragma once

#include <cstdint>

#include "controller/hal/register_bus.hpp"

namespace armature::cosim::iss {

class MpcoreModel {
 public:
  // `offset`: from mpcore::kBase. Registers without a function here read as 0.
  [[nodiscard]] std::uint32_t read(std::uint32_t offset, RegisterBus* bus);
  void write(std::uint32_t offset, std::uint32_t value, RegisterBus* bus);

  // The interrupts that end a WFI. Software interrupts are always enabled.
  [[nodiscard]] Interrupts enabled() const { return enabled_ | Interrupts::kEvent; }
  // What has ended the WFI is pending: a line until the next WFI, an event until it is acknowledged.
  void set_pending(Interrupts lines) { pending_ = lines; }

  [[nodiscard]] std::uint64_t digest() const {
    return std::uint64_t{static_cast<std::uint32_t>(enabled_)} << 32 | static_cast<std::uint32_t>(pending_);
  }

 private:
  Interrupts enabled_ = Interrupts::kNone;  // lines of the logic
  Interrupts pending_ = Interrupts::kNone;
};

}  // namespace armature::cosim::iss
