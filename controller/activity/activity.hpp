// What the ways to move the arm have in common on core 1: plans, a jog, a stream, homing, a part on the conveyor.
//
// An activity also has, for each command that it takes,
//
//   std::optional<MoveRefused> accept(const C& command) noexcept;
//
// It returns why the command is refused, without the tag, or nothing. Dispatcher finds the activity by the type of the
// command. ArmOwner knows which activity has the arm.
#pragma once

#include <cstdint>

#include "controller/message/move_refused.hpp"
#include "controller/motion/mailbox.hpp"

namespace armature {

enum class ActivityId : std::uint8_t { kPlans, kJog, kStream, kHoming, kConveyor };

enum class StopKind : std::uint8_t {
  kHold,   // within the limits of the motion; plans continue afterwards
  kSoft,   // within the limits of the motion
  kQuick,  // with the full acceleration of the joints
};

class Activity {
 public:
  // False: it has work that core 0 does not have, or has not executed.
  [[nodiscard]] virtual bool idle() const noexcept { return true; }
  // Brings the arm to rest if the activity has it. Plans are stopped by ArmOwner.
  virtual void stop(StopKind) noexcept {}
  // Reports as refused what core 0 does not have. kReplaced: only what came before the joint move that begins at once.
  virtual void drop(Refusal) noexcept {}
  // The arm stands, or a fault has ended its motion.
  virtual void on_rest() noexcept {}
  // False: core 0 will answer what the activity has sent since the notice.
  [[nodiscard]] virtual bool answered_by(const MotionNotice&) const noexcept { return true; }

 protected:
  Activity() = default;
  Activity(const Activity&) = delete;
  Activity& operator=(const Activity&) = delete;
  ~Activity() = default;  // never owned through this interface
};

}  // namespace armature
