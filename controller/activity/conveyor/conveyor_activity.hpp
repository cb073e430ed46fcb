// Paths in the frame of a part on the conveyor, on core 1.
//
// A path is planned as if the frame stood, then checked on the moving belt (part_planning.hpp). Core 0 follows the part
// from the first path on: the conveyor has the arm, and executes the moves of the queue. It releases the part for the
// first move in another frame. Such a path is one plan and no window, and begins when the arm stands.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/activity/activity.hpp"
#include "controller/activity/activity_context.hpp"
#include "controller/activity/conveyor/part_planning.hpp"
#include "controller/activity/plans/plan_activity.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/message/command.hpp"

namespace armature {

class ConveyorActivity final : public Activity {
 public:
  // `plans` must outlive the object.
  ConveyorActivity(const ActivityContext& context, PlanActivity& plans) noexcept;

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

  ActivityContext context_;
  PlanActivity& plans_;
  PathStage& path_;
  PartPlanning part_;
};

}  // namespace armature
