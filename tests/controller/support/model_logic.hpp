// The model of the logic (cosim/model, variant with counts) with its drives and tool, as the controller's registers
// show it: an access takes one clock edge, and no edge of the bus is computed.
//
// It is core 0's RegisterBus. Time passes with every access and charge; wait_for_interrupt() runs to the next trigger.
// An access that the logic refuses throws std::logic_error, which ends the program where it comes from a driver.
//
// Encoder lines are not computed: the positions are the counts of the drives at the trigger. Ticks without a
// disturbance are computed as a whole (cosim/model/README.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/regs/soc_map.hpp"
#include "controller/robot/robot_model.hpp"
#include "cosim/logic/pins.hpp"
#include "tests/controller/support/planted_registers.hpp"
#include "tests/controller/support/simple_drive.hpp"

namespace armature::test {

class ModelLogic final : public RegisterBus {
 public:
  static constexpr RegAddr kPulses{regs::soc::kPulseTrainBase};
  static constexpr RegAddr kEncoder{regs::soc::kEncoderBase};
  static constexpr RegAddr kTool{regs::soc::kAxiGpioBase};
  static constexpr std::int64_t kTick = regs::soc::kTickCycles;

  ModelLogic();
  ModelLogic(const ModelLogic&) = delete;
  ~ModelLogic();

  // Cost of what core 0 does, in cycles. An access takes one at least.
  std::int64_t access_cycles = 18, tick_cycles = 250, work_cycles = 50;

  // World.
  cosim::SocInputs pins;  // levels from now on; of the encoder lines and the UART only these
  PerAxis<SimpleDrive> drives;
  void fit_drives(const RobotModel& robot);
  void set_tool_input(int pin, bool level);               // 1..16
  void pass_index(std::size_t axis, std::int64_t count);  // the index of the encoder has come at that count
  PlantedRegisters planted;

  std::function<void(std::int64_t)> on_trigger;  // after the logic has acted; the number of the trigger, from 0
  std::function<void()> on_wait = [] {};         // core 0 begins to wait for the interrupt
  std::function<void()> on_event = [] {};        // core 0 sends an event
  std::int64_t triggers_to_run = 0;              // then the core is switched off
  void pass(std::int64_t cycles);
  // The clock of the logic stands still for this time, the processor's does not.
  void stand_still(std::int64_t cycles) { stood_ += cycles; }

  // What came out, for checks.
  [[nodiscard]] const cosim::SocOutputs& outputs() const;
  [[nodiscard]] std::uint32_t servo_on() const { return outputs().servo_on; }
  [[nodiscard]] std::uint32_t tool_outputs() const { return outputs().gpio; }  // bit i is pin i + 1
  [[nodiscard]] bool tool_interrupts() const;
  [[nodiscard]] std::uint32_t peek(RegAddr addr) const;  // a read that leaves everything as it is
  [[nodiscard]] std::uint32_t underruns() const;
  [[nodiscard]] std::uint32_t faults_read() const { return faults_read_; }  // all flags of FAULT that core 0 has read
  [[nodiscard]] std::int64_t emitted(std::size_t axis) const;               // net pulses
  [[nodiscard]] std::int64_t count(std::size_t axis) const { return drives[axis].count(); }  // encoder now
  [[nodiscard]] std::int64_t triggers() const { return triggers_; }
  [[nodiscard]] std::int64_t largest_count() const;  // most pulses of an axis in a tick

  // An access that takes so many cycles, one if it is of core 1, which has a bus of its own.
  std::uint32_t read(RegAddr addr, std::int64_t cycles = 1);
  void write(RegAddr addr, std::uint32_t value, std::int64_t cycles = 1);

  // RegisterBus
  std::uint32_t read32(RegAddr addr) noexcept override;
  void write32(RegAddr addr, std::uint32_t value) noexcept override;
  Interrupts wait_for_interrupt(Interrupts mask) noexcept override;
  void send_event() noexcept override { on_event(); }
  Cycles now() noexcept override;
  void charge(Work work, std::int64_t times) noexcept override;

 private:
  class Chip;

  void triggered();

  std::unique_ptr<Chip> chip_;
  std::int64_t stood_ = 0;
  std::int64_t triggers_ = 0;
  std::uint32_t faults_read_ = 0;
};

}  // namespace armature::test
