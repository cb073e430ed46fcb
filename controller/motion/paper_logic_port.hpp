// LogicPort over the logic of Vo 2021: half periods instead of counts, one decoder behind a switch.
//
// Pulses. A count becomes the half period that emits the nearest count a drive accepts (half_period.hpp); what really
// comes out is known before, and the difference is `not_emitted` at the next look, so that the quantizer carries it
// into the ticks that follow. The EMITTED registers have the last word: a width stands until it is replaced, so a core
// that is late goes on moving, and a trigger between two writes mixes old and new widths; both show there and are made
// good a tick or two later. An axis turns round only after its last pulse has been low for the drive's hold time, else
// it pauses for a tick, and with at least the drive's set-up time as half period.
//
// What the logic lacks is made up from its clock: `pending` is true when the widths were written after the last
// trigger, which then started the old ones once more; a trigger within the few cycles between the last write and the
// look at the clock counts as before it. There are no underruns and no watchdog.
//
// Positions. The encoder of an axis is the sum of the differences that the decoder saw while it was selected, each from
// the first trigger after the switch to the last before the next. With a fixed axis that one is complete and `seen`. In
// turn an axis is watched for switch_every - 1 of (axes * switch_every) ticks, none is `seen`, and the decoder's
// illegal transitions, which the switch itself causes, are no fault.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/drivers/axi_timer.hpp"
#include "controller/drivers/encoder_switch.hpp"
#include "controller/drivers/pulse_width.hpp"
#include "controller/drivers/single_encoder.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/motion/half_period.hpp"
#include "controller/motion/logic_port.hpp"

namespace armature {

// What the one decoder watches.
struct PaperEncoders {
  std::size_t axis = 0;  // 0..5: this one; with switch_every the first one
  Ticks switch_every{};  // 0: never; else at least 2: every axis of the robot in turn, so many ticks each
};

class PaperLogicPort final : public LogicPort {
 public:
  PaperLogicPort(RegisterBus& bus, const PaperEncoders& encoders) noexcept
      : timer_{bus}, pulse_width_{bus}, switch_{bus}, decoder_{bus}, encoders_{encoders}, selected_{encoders.axis} {}

  [[nodiscard]] bool identified() noexcept override;
  void start(const RobotModel& robot) noexcept override;
  void acknowledge() noexcept override { timer_.acknowledge(); }
  [[nodiscard]] const LogicInput& sample() noexcept override;
  void commit(const PerAxis<Pulses>& counts) noexcept override;
  void set_servo(bool on) noexcept override { pulse_width_.set_servo(on ? PulseWidth::kAllAxes : std::uint8_t{0}); }
  void clear_faults() noexcept override;
  [[nodiscard]] const PerAxis<Pulses>& emitted() noexcept override;

 private:
  [[nodiscard]] bool in_turn() const noexcept { return encoders_.switch_every > Ticks{0}; }
  [[nodiscard]] Cycles choose_width(std::size_t axis, Pulses count) const noexcept;
  void switch_if_due() noexcept;
  void read_position() noexcept;
  void read_emitted() noexcept;
  void account_for_emission() noexcept;
  void find_blind() noexcept;

  AxiTimer timer_;
  PulseWidth pulse_width_;
  EncoderSwitch switch_;
  SingleEncoder decoder_;

  PaperEncoders encoders_;
  std::size_t axis_count_ = kAxes;
  std::size_t selected_;
  Ticks selected_for_{};          // commits since the switch
  bool watching_ = false;         // a trigger has passed since the switch: position_ belongs to selected_
  std::int32_t position_ = 0;     // of the decoder at the last look
  std::uint32_t written_at_ = 0;  // clock time after the last commit

  std::optional<HalfPeriodTable> widths_;   // set by start()
  std::optional<HalfPeriodTable> turning_;  // for the first tick in a new direction
  Cycles dir_hold_{};
  PerAxis<int> direction_{};     // of the last width that was not 0; 0: none yet
  PerAxis<Cycles> written_{};    // widths in the registers
  PerAxis<Cycles> active_{};     // of this tick while written_ still wait
  PerAxis<Pulses> emitted_{};    // up to the last trigger
  PerAxis<Pulses> accounted_{};  // what the motion loop takes for emitted or about to be
};

}  // namespace armature
