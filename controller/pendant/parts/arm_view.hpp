// The state of the arm as the pendant sees it: what core 0 has reported, the program, the keys of jogs, and what the
// operator has not yet acknowledged.
#pragma once

#include <cstdint>

#include "controller/activity/owner_state.hpp"
#include "controller/base/units.hpp"
#include "controller/language/program/program_client.hpp"
#include "controller/message/event.hpp"
#include "controller/pendant/parts/pressed_axes.hpp"
#include "controller/pendant/protocol/frame_table.hpp"

namespace armature::pendant {

class ArmView {
 public:
  // References must outlive the view.
  ArmView(const OwnerState& owner, const ProgramClient& program, const PressedAxes& keys) noexcept
      : owner_{owner}, program_{program}, keys_{keys} {}

  // What is worse comes first.
  [[nodiscard]] State state(Cycles now) const noexcept;
  [[nodiscard]] bool drives_on() const noexcept { return started_ && !owner_.fault(); }
  // A jog is under way, or a key of one is pressed.
  [[nodiscard]] bool jogs(Cycles now) const noexcept { return owner_.jogs() || keys_.any(now); }
  // The same, or something else is under way.
  [[nodiscard]] bool moves(Cycles now) const noexcept { return jogs(now) || owner_.moves() || axes_to_home_ != 0; }
  // As in Page::kAlarm.
  [[nodiscard]] std::int32_t alarm() const noexcept;

  void on_event(const Event& event) noexcept;
  // The operator lets these axes be homed: bit 0 for axis 1.
  void expect_homing(std::uint8_t axes) noexcept { homing_asked_ = axes; }
  void latch_estop() noexcept { estop_ = true; }
  void reset_estop() noexcept {
    estop_ = false;
    alarm_ = true;
  }
  void reset_alarm() noexcept { alarm_ = false; }

 private:
  const OwnerState& owner_;
  const ProgramClient& program_;
  const PressedAxes& keys_;
  bool started_ = false;  // the controller has started the drives once
  bool estop_ = false;    // an emergency stop is latched
  bool alarm_ = false;    // the arm is in Fault for another cause, or the emergency stop was reset
  // Axes that the operator lets be homed. No event tells that further ones wait while none is being homed.
  std::uint8_t homing_asked_ = 0;  // before the first one has started
  std::uint8_t axes_to_home_ = 0;  // from then on: those that are not over
};

}  // namespace armature::pendant
