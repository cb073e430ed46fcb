// The bus of a core that runs alone with the chip. It receives what the core sends on the serial line.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "cosim/cpu/core_bus.hpp"
#include "cosim/serial/line_receiver.hpp"
#include "cosim/serial/serial_format.hpp"
#include "cosim/soc/soc.hpp"

namespace armature::cosim {

class ConsoleBus final : public CoreBus {
 public:
  // What the core has executed so far.
  using Instructions = std::function<std::int64_t()>;

  // Nothing happens after `longest`. The chip must outlive the bus.
  ConsoleBus(Soc& soc, const SerialFormat& format, Cycles longest, Instructions instructions)
      : soc_{soc}, receiver_{format}, longest_{longest}, instructions_{std::move(instructions)} {}

  std::uint32_t read32(RegAddr addr) noexcept override { return access({.write = false, .addr = addr.value}); }
  void write32(RegAddr addr, std::uint32_t value) noexcept override {
    access({.write = true, .addr = addr.value, .data = value});
  }
  // kNone, which ends the core: it waits for no line of the logic, or `longest` has passed.
  Interrupts wait_for_interrupt(Interrupts mask) noexcept override;
  void send_event() noexcept override {}
  Cycles now() noexcept override { return soc_.now(); }
  void charge(Work work, std::int64_t times) noexcept override;
  void pass(Cycles duration) noexcept override;

  // What the line has received.
  [[nodiscard]] const std::string& text() const { return text_; }
  // Characters with an error, and accesses without an answer or with an error.
  [[nodiscard]] int failures() const { return failures_; }
  // Lets time pass until the text ends with `end`. False: `longest` has passed before.
  [[nodiscard]] bool receive_until(std::string_view end);

  // From the latest access before the first charge for kInverse to this charge.
  struct Measured {
    std::int64_t instructions = 0;
    Cycles clocks{};
  };
  [[nodiscard]] const Measured& inverse() const { return inverse_; }

 private:
  std::uint32_t access(const BusRequest& request);
  void step(Cycles limit);
  void take_character();

  Soc& soc_;
  LineReceiver receiver_;
  Cycles longest_;
  Instructions instructions_;
  std::string text_;
  int failures_ = 0;
  bool txd_ = true;
  Measured latest_access_;  // at its end
  Measured inverse_;
  bool measured_ = false;
};

}  // namespace armature::cosim
