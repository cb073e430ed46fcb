// LogicPort over the logic of Vo 2021: half periods instead of counts, one decoder behind a switch.
//
// Pulses. A count becomes the half period that emits the nearest count a drive accepts (half_period.hpp). The emitted
// number is known in advance; the difference is `not_emitted` of the next sample, so that the quantizer adds it to the
// following ticks. The EMITTED registers decide. A width stays active until it is replaced, so an axis moves on when
// the core is late, and a trigger between two writes mixes old and new widths. Both show in EMITTED and are corrected
// one or two ticks later. An axis changes direction only when its last pulse has been low for the drive's hold time,
// otherwise it pauses for a tick. The first half period in the new direction is at least the drive's set-up time.
//
// The logic has no status of commits, so it is derived from its clock. `pending` is true when the widths were written
// after the last trigger, which then started the old widths once more. A trigger within the few cycles between the last
// write and the reading of the clock counts as before the write. There are no underruns and no watchdog.
//
// Positions. The encoder of an axis is the sum of the differences that the decoder counted while the axis was selected,
// each from the first trigger after the switch to the last before the next switch. With a fixed axis, that axis is
// complete and `always_counted`. With switching, an axis is counted for switch_every - 1 of (axes * switch_every) ticks
// and no axis is `always_counted`. The decoder's illegal transitions, which the switch itself causes, are then not a
// fault.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/base/members.hpp"
#include "controller/base/misfit.hpp"
#include "controller/drivers/axi_timer.hpp"
#include "controller/drivers/encoder_switch.hpp"
#include "controller/drivers/pulse_width.hpp"
#include "controller/drivers/single_encoder.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/motion/half_period.hpp"
#include "controller/motion/logic_port.hpp"

namespace armature {

// The selection of the one decoder.
struct PaperEncoders {
  std::uint32_t axis = 0;  // 0..5: this axis; with switch_every the first one
  Ticks switch_every{};    // 0: no switching; else at least 2: every axis of the robot in turn, for so many ticks each

  [[nodiscard]] constexpr const void* misfit() const noexcept {
    return first_misfit({{&axis, axis < kAxes}, {&switch_every, switch_every == Ticks{0} || switch_every >= Ticks{2}}});
  }
  ARMATURE_MEMBERS(PaperEncoders, axis, switch_every)
};

class PaperLogicPort final : public LogicPort {
 public:
  PaperLogicPort(RegisterBus& bus, const PaperEncoders& encoders) noexcept
      : timer_{bus}, pulse_width_{bus}, switch_{bus}, decoder_{bus}, encoders_{encoders}, selected_{encoders.axis} {}

  [[nodiscard]] bool identified() noexcept override;
  void start(const RobotModel& robot) noexcept override;
  void acknowledge() noexcept override { timer_.acknowledge(); }
  [[nodiscard]] const LogicInput& sample() noexcept override;
  // Not used: the one decoder counts one axis at a time.
  [[nodiscard]] std::optional<Counts> index(std::size_t) noexcept override { return std::nullopt; }
  void commit(const PerAxis<Pulses>& counts) noexcept override;
  void set_servo(bool on) noexcept override { pulse_width_.set_servo(on ? PulseWidth::kAllAxes : std::uint8_t{0}); }
  void clear_faults() noexcept override;
  [[nodiscard]] const PerAxis<Pulses>& emitted() noexcept override;

 private:
  [[nodiscard]] bool multiplexed() const noexcept { return encoders_.switch_every > Ticks{0}; }
  [[nodiscard]] Cycles choose_width(std::size_t axis, Pulses count) const noexcept;
  void switch_if_due() noexcept;
  void read_position() noexcept;
  void read_emitted() noexcept;
  void account_for_emission() noexcept;
  void read_uncounted_axes() noexcept;

  AxiTimer timer_;
  PulseWidth pulse_width_;
  EncoderSwitch switch_;
  SingleEncoder decoder_;

  PaperEncoders encoders_;
  std::size_t axis_count_ = kAxes;
  std::size_t selected_;
  Ticks selected_for_{};          // commits since the last switch
  bool position_valid_ = false;   // a trigger has passed since the switch: position_ belongs to selected_
  std::int32_t position_ = 0;     // of the decoder at the last sample
  std::uint32_t written_at_ = 0;  // clock time after the last commit

  std::optional<HalfPeriodTable> widths_;   // set by start()
  std::optional<HalfPeriodTable> turning_;  // for the first tick in a new direction
  Cycles dir_hold_{};
  PerAxis<int> direction_{};     // of the last width that was not 0; 0: none yet
  PerAxis<Cycles> written_{};    // widths in the registers
  PerAxis<Cycles> active_{};     // of this tick, while written_ wait for the trigger
  PerAxis<Pulses> emitted_{};    // up to the last trigger
  PerAxis<Pulses> accounted_{};  // pulses that the motion loop assumes as emitted or about to be emitted
};

}  // namespace armature
