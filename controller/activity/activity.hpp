// What the ways to move the arm have in common on core 1: plans, a jog, a stream, homing, a part on the conveyor.
//
// An activity also has, for each command that it takes,
//
//   std::optional<MoveRefused> accept(const C& command) noexcept;
//
// It returns why the command is refused, without the tag, or nothing. Dispatcher finds the activity by the type of the
// command. ArmOwner knows which activity has the arm.
#pragma once

#include "controller/activity/activity_id.hpp"
#include "controller/message/move_refused.hpp"
#include "controller/motion/loop_channel.hpp"

namespace armature {

class Activity {
 public:
  // False: it has work that core 0 does not have, or has not executed.
  [[nodiscard]] virtual bool idle() const noexcept { return true; }
  // A Hold or a Stop has come. ArmOwner brings the arm to rest.
  virtual void on_stop(StopKind) noexcept {}
  // Reports as refused what core 0 does not have. kReplaced: only what came before the joint move that begins at once.
  virtual void drop(Refusal) noexcept {}
  // To a request that is not about the whole arm.
  virtual void on_answer(const Answer&) noexcept {}
  // The arm stands, or a fault has ended its motion.
  virtual void on_rest() noexcept {}

 protected:
  Activity() = default;
  Activity(const Activity&) = delete;
  Activity& operator=(const Activity&) = delete;
  ~Activity() = default;  // never owned through this interface
};

}  // namespace armature
