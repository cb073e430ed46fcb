// Paths in the frame of a part on the conveyor, on core 1.
//
// A path is planned as if the frame stood, then checked on the moving belt (part_planning.hpp). Core 0 follows the part
// from the first path on: the conveyor has the arm, and executes the moves of the queue. It releases the part for the
// first move in another frame. Such a path is one plan and no window, and begins when the arm stands.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/activity/activity.hpp"
#include "controller/activity/arm_owner.hpp"
#include "controller/activity/conveyor/part_planning.hpp"
#include "controller/activity/move_queue.hpp"
#include "controller/activity/plans/plan_activity.hpp"
#include "controller/cell/frames.hpp"
#include "controller/cell/planning_config.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/message/command.hpp"
#include "controller/message/event.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class ConveyorActivity final : public Activity {
 public:
  // References must outlive the object. The last one of `frames` becomes the frame in which a path is planned.
  ConveyorActivity(const RobotModel& robot, const Arm& arm, const PlanningConfig& config, UserFrames& frames,
                   ArmOwner& owner, MoveQueue& queue, PlanActivity& plans, Channel& channel,
                   EventListener& events) noexcept;

  [[nodiscard]] std::optional<MoveRefused> accept(const ConveyorPart& part) noexcept;

  // A path on a part is being planned.
  [[nodiscard]] bool plans() const noexcept { return path_.on_part(); }
  // One step of that; false: there is no room.
  [[nodiscard]] bool work(RegisterBus& bus) noexcept;
  // Executes the front of the queue, a path on a part, a dwell, or another move, for which the arm leaves the part.
  // False: it waits. `stands`: the arm is at the end of all that core 0 has.
  [[nodiscard]] bool execute(const CartesianMove& move, bool stands, RegisterBus& bus) noexcept;
  [[nodiscard]] bool execute(const Dwell& dwell, RegisterBus& bus) noexcept;
  [[nodiscard]] bool release() noexcept;
  // Core 0 has executed all that was sent while it follows a part.
  [[nodiscard]] bool stands() const noexcept { return part_.done(); }
  [[nodiscard]] bool waits_for_time() const noexcept { return part_.waits_for_time(); }
  // Inverse kinematics computed since the last call.
  [[nodiscard]] std::int64_t take_inverses() noexcept { return part_.take_inverses(); }

  // Activity
  void on_stop(StopKind how) noexcept override;
  void drop(Refusal) noexcept override { part_.ended(); }

 private:
  void check(RegisterBus& bus) noexcept;
  void lose_part() noexcept;
  void clear_path() noexcept;

  const PlanningConfig& config_;
  UserFrames& frames_;
  ArmOwner& owner_;
  MoveQueue& queue_;
  PlanActivity& plans_;
  PathStage& path_;
  EventListener& events_;
  PartPlanning part_;
};

}  // namespace armature
