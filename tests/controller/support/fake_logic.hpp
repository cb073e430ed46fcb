// The programmable logic of either variant with its drives, encoders and tool, as the controller's registers show it:
// a register-level fake, written from the register descriptions, that runs the controller without RTL.
//
// It is core 0's RegisterBus. Time passes with every access and charge; wait_for_interrupt() runs to the next trigger.
// It ends the program at an access to a register that no driver of the variant uses, and at a write to a protected
// register while a servo is on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/regs/axi_gpio_regs.hpp"
#include "controller/regs/encoder_regs.hpp"
#include "controller/regs/encoder_switch_regs.hpp"
#include "controller/regs/pulse_train_regs.hpp"
#include "controller/regs/soc_map.hpp"
#include "controller/robot/robot_model.hpp"
#include "tests/controller/support/fake_drive.hpp"

namespace armature::test {

class FakeLogic final : public RegisterBus {
  static constexpr std::size_t kWordsPerBlock = 128;
  static constexpr std::size_t kWords = 8 * kWordsPerBlock;
  std::array<std::uint32_t, kWords> words_{};  // what a read gives, or what was written last

  // The bits of a base that differ from block to block, then the offset.
  static constexpr std::size_t index(RegAddr addr) {
    const std::uint32_t base = addr.value >> 16;
    return ((base & 3u) + ((base >> 4) & 6u)) * kWordsPerBlock + ((addr.value & 0x1FFu) >> 2);
  }

 public:
  enum class Variant : std::uint8_t { kCounts, kPaper };

  static constexpr RegAddr kPulses{regs::soc::kPulseTrainBase};  // pulse_width has the same base and layout
  static constexpr RegAddr kEncoder{regs::soc::kEncoderBase};
  static constexpr RegAddr kSwitch{regs::soc::kEncoderSwitchBase};
  static constexpr RegAddr kTool{regs::soc::kAxiGpioBase};
  static constexpr std::int64_t kTick = regs::soc::kTickCycles;

  // Pulses are emitted and drives move in so many steps of a tick, each at its end; a divisor of kTick.
  explicit FakeLogic(Variant variant = Variant::kCounts, std::int64_t sub_steps = 50);
  FakeLogic(const FakeLogic&) = delete;

  // Cost of what core 0 does, in cycles.
  std::int64_t access_cycles = 18, tick_cycles = 250, work_cycles = 50;

  // World. A word is what a read of that register gives.
  [[nodiscard]] std::uint32_t& word(RegAddr addr) { return words_[index(addr)]; }
  std::uint32_t& pulses_id = word(kPulses + regs::pulse_train::kIdOffset);
  std::uint32_t& encoder_id = word(kEncoder + regs::encoder::kIdOffset);
  std::uint32_t& switch_id = word(kSwitch + regs::encoder_switch::kIdOffset);
  std::uint32_t& encoder_known = word(kEncoder + regs::encoder::kKnownOffset);
  std::uint32_t& switches = word(kPulses + regs::pulse_train::kSwitchesOffset);
  std::uint32_t& index_seen = word(kEncoder + regs::encoder::kIndexSeenOffset);
  [[nodiscard]] std::uint32_t& index_position(std::size_t axis) {
    return word(kEncoder + (regs::encoder::kIndexPositionOffset + 4 * static_cast<std::uint32_t>(axis)));
  }
  std::uint32_t& alarm = word(kPulses + regs::pulse_train::kDrivesOffset);
  PerAxis<FakeDrive> drives;
  void fit_drives(const RobotModel& robot);
  bool estop_pin = false;
  std::uint32_t encoder_fault = 0;           // events: the next trigger sets the flags once
  PerAxis<std::int64_t> shorten{};           // pulses that will not fit in the tick that starts next
  std::int64_t switch_artefact = 1;          // counts as which the decoder takes a turn of the switch
  void set_tool_input(int pin, bool level);  // 1..16

  std::function<void(std::int64_t)> on_trigger;  // after the logic has acted; the number of the trigger, from 0
  std::function<void()> on_wait = [] {};         // core 0 begins to wait for the interrupt
  std::function<void()> on_event = [] {};        // core 0 sends an event
  std::int64_t triggers_to_run = 0;              // then the core is switched off
  void pass(std::int64_t cycles);
  [[nodiscard]] std::int64_t cycles_to_trigger() const { return tick_start_ + kTick - now_; }

  // What came out, for checks.
  const std::uint32_t& underruns = word(kPulses + regs::pulse_train::kUnderrunsOffset);
  const std::uint32_t& dir_setup = word(kPulses + regs::pulse_train::kDirSetupOffset);
  const std::uint32_t& dir_hold = word(kPulses + regs::pulse_train::kDirHoldOffset);
  const std::uint32_t& selected = word(kSwitch + regs::encoder_switch::kSelectOffset);
  const std::uint32_t& tool_outputs = word(kTool + regs::axi_gpio::kDataOffset);  // bit i is pin i + 1
  std::vector<std::string> breaches;  // of the 25 cycles around a change of direction, which the paper's variant owes
  [[nodiscard]] const PerAxis<std::int64_t>& emitted() const { return emitted_; }
  [[nodiscard]] std::int64_t emitted(std::size_t axis) const { return emitted_[axis]; }
  [[nodiscard]] std::int64_t active_count(std::size_t axis) const { return active_[axis]; }
  [[nodiscard]] std::int64_t count(std::size_t axis) const { return drives[axis].count(); }  // encoder now
  [[nodiscard]] std::int64_t width(std::size_t axis) const;                                  // as written last
  [[nodiscard]] std::int64_t triggers() const { return triggers_; }
  [[nodiscard]] std::uint32_t recommits() const { return recommits_; }
  [[nodiscard]] std::int64_t largest_count() const { return largest_count_; }
  [[nodiscard]] std::uint32_t servo_on() const;
  [[nodiscard]] bool tool_interrupts() const;

  // An access that takes no time: of core 1, which has a bus of its own.
  [[nodiscard]] std::uint32_t read(RegAddr addr) const;
  void write(RegAddr addr, std::uint32_t value);

  // The clock of the logic stands still for this time, the processor's does not.
  void stand_still(std::int64_t cycles) {
    now_ += cycles;
    tick_start_ += cycles;
  }

  // RegisterBus
  std::uint32_t read32(RegAddr addr) noexcept override {
    if (access_cycles != 0) pass(access_cycles);
    return kinds_[index(addr)] >= Kind::kActive ? words_[index(addr)] : read(addr);
  }
  void write32(RegAddr addr, std::uint32_t value) noexcept override {
    if (access_cycles != 0) pass(access_cycles);
    kinds_[index(addr)] == Kind::kMemory ? void(words_[index(addr)] = value) : write(addr, value);
  }
  Interrupts wait_for_interrupt(Interrupts mask) noexcept override;
  void send_event() noexcept override { on_event(); }
  Cycles now() noexcept override { return Cycles{now_}; }
  void charge(Work work, std::int64_t times) noexcept override;

 private:
  // By what a driver's access does besides loading or storing the word; kTime is read only.
  enum class Kind : std::uint8_t { kUnused, kTime, kActive, kMemory };

  [[nodiscard]] std::uint32_t word(RegAddr addr) const { return words_[index(addr)]; }
  [[nodiscard]] bool stopped() const;
  void latch(std::uint32_t stop);
  void sub_step(std::int64_t number);
  void trigger();
  void show_positions();
  void start_counts();
  void start_width(std::size_t axis);
  void commit(std::uint32_t sequence);
  void refuse_if_protected(RegAddr addr) const;

  const bool paper_;
  const std::int64_t step_cycles_;
  std::array<Kind, kWords> kinds_{};
  std::int64_t now_ = 0;
  std::int64_t tick_start_ = -1;  // -1: the timer stands
  bool interrupt_ = false;
  std::int64_t triggers_ = 0;
  PerAxis<std::int64_t> pending_{}, active_{}, widths_{}, emitted_{}, in_tick_{}, cut_{};
  PerAxis<bool> forward_{};
  std::uint32_t in_a_row_ = 0, recommits_ = 0;
  std::int64_t largest_count_ = 0;
  std::int64_t decoded_ = 0;  // counts of the one decoder that the selected encoder did not make
};

}  // namespace armature::test
