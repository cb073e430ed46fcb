// The accesses of a core to a chip that runs alone, one after the other.
#pragma once

#include <cstdint>

#include "controller/base/units.hpp"
#include "controller/hal/register_bus.hpp"
#include "cosim/soc/soc.hpp"

namespace armature::cosim {

// It never sleeps, and computing takes no time.
class ChipBus final : public RegisterBus {
 public:
  // The chip must outlive the bus.
  explicit ChipBus(Soc& soc) : soc_{soc} {}

  // An access without an answer reads 0.
  std::uint32_t read32(RegAddr addr) noexcept override { return access({.write = false, .addr = addr.value}); }
  void write32(RegAddr addr, std::uint32_t value) noexcept override {
    access({.write = true, .addr = addr.value, .data = value});
  }
  Interrupts wait_for_interrupt(Interrupts /*mask*/) noexcept override { return Interrupts::kNone; }
  void send_event() noexcept override {}
  Cycles now() noexcept override { return soc_.now(); }
  void charge(Work /*work*/, std::int64_t /*times*/) noexcept override {}

  // Accesses without an answer or with an error.
  [[nodiscard]] int failures() const { return failures_; }

 private:
  std::uint32_t access(const BusRequest& request) {
    soc_.start(request);
    soc_.advance(soc_.now() + soc_.access_timeout(), StopOn::kAccess);
    const auto response = soc_.pop_response();
    failures_ += response && response->error == BusError::kNone ? 0 : 1;
    return response ? response->data : 0;
  }

  Soc& soc_;
  int failures_ = 0;
};

}  // namespace armature::cosim
