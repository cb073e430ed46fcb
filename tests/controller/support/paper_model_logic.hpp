// The model of the logic of Vo 2021 (cosim/model, variant paper) as a register bus, with six encoders that follow each
// pulse at once. Every edge at which something happens is computed; an access takes one edge, without the bus.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "controller/base/axes.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/regs/soc_map.hpp"
#include "tests/controller/support/planted_registers.hpp"

namespace armature::test {

class PaperModelLogic final : public RegisterBus {
 public:
  static constexpr RegAddr kPulses{regs::soc::kPulseWidthBase};
  static constexpr RegAddr kEncoder{regs::soc::kEncoderBase};
  static constexpr RegAddr kSwitch{regs::soc::kEncoderSwitchBase};

  PaperModelLogic();
  PaperModelLogic(const PaperModelLogic&) = delete;
  ~PaperModelLogic();

  static constexpr std::int64_t kAccessCycles = 18;

  // World.
  bool estop_pin = false;
  PerAxis<std::int64_t> offsets{};  // counts of the encoders without pulses; a step by 2 is an illegal transition
  bool has_encoders = true;         // false: the lines stand still
  PlantedRegisters planted;

  void pass(std::int64_t cycles);
  void pass_to_trigger() { pass(cycles_to_trigger()); }
  [[nodiscard]] std::int64_t cycles_to_trigger() const;  // until the next one has acted

  // What came out, for checks.
  std::vector<std::string> breaches;                           // of the 25 cycles around a change of direction
  [[nodiscard]] const PerAxis<std::int64_t>& emitted() const;  // net pulses
  [[nodiscard]] std::int64_t emitted(std::size_t axis) const { return emitted()[axis]; }
  [[nodiscard]] std::int64_t last_tick(std::size_t axis) const;  // pulses between the last two triggers
  [[nodiscard]] std::int64_t width(std::size_t axis);            // as written last
  [[nodiscard]] std::uint32_t selected();
  [[nodiscard]] std::uint32_t servo_on() const;

  // RegisterBus
  std::uint32_t read32(RegAddr addr) noexcept override;
  void write32(RegAddr addr, std::uint32_t value) noexcept override;
  Interrupts wait_for_interrupt(Interrupts) noexcept override { return Interrupts::kNone; }
  void send_event() noexcept override {}
  Cycles now() noexcept override;
  void charge(Work, std::int64_t) noexcept override {}

 private:
  class Chip;

  std::unique_ptr<Chip> chip_;
};

}  // namespace armature::test
