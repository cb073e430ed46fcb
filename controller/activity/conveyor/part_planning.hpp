// The conveyor on core 1: the parts that came, the frame in which moves are planned, and the check of a plan on the
// moving belt.
//
// The planner plans a path as if its frame stood still at one displacement. Then the same motion that core 0 will
// execute (activity/conveyor/conveyor_motion.hpp) is computed for two belts, slower and faster than the present one by
// ConveyorConfig::speed_tolerance, with a share of the limits of the joints. A plan that does not pass is made slower,
// and refused when that does not help, or when the belt would leave the window. A target of a camera is assumed to come
// to rest at the end of the window: a hand turns it round. What the belt does later is checked in each tick.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/activity/conveyor/conveyor_motion.hpp"
#include "controller/activity/conveyor/part_store.hpp"
#include "controller/activity/plans/stages/plan_outbox.hpp"
#include "controller/base/axes.hpp"
#include "controller/base/spsc_queue.hpp"
#include "controller/base/units.hpp"
#include "controller/cell/planning_config.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/message/command.hpp"
#include "controller/message/move_refused.hpp"
#include "controller/message/part_followed.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/state/phase_law.hpp"

namespace armature {

class PartPlanning {
 public:
  static constexpr std::size_t kParts = 16;
  static constexpr double kLimitShare = 0.95;  // of the limits of the joints, for the check of a plan
  // The factor of the next try of a plan that is too fast, and the number of tries.
  static constexpr double kSlower = 1.25;
  static constexpr int kTries = 6;

  // References must outlive the object. Without `config.conveyor` no function is used but
  // waits_for_time() and take_inverses().
  PartPlanning(const RobotModel& robot, const Arm& arm, const PlanningConfig& config, PlanOutbox& outbox,
               PartStore& store) noexcept;

  void add(const ConveyorPart& part) noexcept;

  // A move waits for a part that comes nearer: core 1 must be woken in each tick.
  [[nodiscard]] bool waits_for_time() const noexcept { return approaching_; }

  enum class Ready : std::uint8_t { kNotYet, kNow, kTooFast, kUnreachable };
  // Prepares the planning of a path. The first one of a part: the arm stands at `joints`. A later one, while the arm
  // follows the part: `joints` is the end of the path before; it becomes the same point in the frame where that will be
  // then.
  [[nodiscard]] Ready prepare_first() noexcept;
  [[nodiscard]] Ready prepare_next(PerAxis<Radians>& joints) noexcept;
  // The frame in which the path is planned.
  [[nodiscard]] Transform base_T_frame() const noexcept { return at(planned_mm_); }
  [[nodiscard]] Transform base_T_part() const noexcept { return at(0.0); }
  // A part that was missed since the last call.
  [[nodiscard]] std::optional<PartFollowed> pop_missed() noexcept;

  enum class Verdict : std::uint8_t { kWorking, kGood, kSlower, kTooFast, kLeavesWindow };
  // The check begins again with the next check().
  void restart_check() noexcept { check_begun_ = false; }
  // The speed and the acceleration that the tool point has in a plan, divided by kSlower and its square.
  [[nodiscard]] static PathLimits slower_limits(const CartesianPlan& plan) noexcept;
  // Continues the check of a plan for `ticks` set-points. `kSlower`: plan it again, with slower_limits().
  [[nodiscard]] Verdict check(const CartesianPlan& plan, std::int64_t ticks) noexcept;
  // Joint 1..6 that could not follow in the last kTooFast; 0: none.
  [[nodiscard]] std::uint8_t axis() const noexcept { return axis_; }
  [[nodiscard]] std::int64_t take_inverses() noexcept;

  // Puts a plan that passed the check into the store, with at most CartesianPlan::kMaxFirstSegments segments. True: it
  // is the first one of a part.
  bool send(const CartesianPlan& plan) noexcept;
  // A dwell while the arm follows a part.
  void send_dwell(const JointPlan& dwell) noexcept;
  // All that was sent is over.
  [[nodiscard]] bool done() const noexcept;
  // The arm does not follow a part any more.
  void ended() noexcept;

 private:
  struct Part {
    double at_mm = 0.0;  // position of the belt when the part passed the sync point
    std::uint32_t number = 0;
  };
  [[nodiscard]] Transform at(double displacement_mm) const noexcept;
  [[nodiscard]] double belt_mm() const noexcept;
  [[nodiscard]] double belt_mm_s() const noexcept;
  [[nodiscard]] double stop_distance_mm(double speed_mm_s) const noexcept;
  void begin_pass(const CartesianPlan& plan) noexcept;
  [[nodiscard]] double assumed_mm_s() const noexcept;
  [[nodiscard]] ConveyorRequest& next_request() noexcept;
  void send_request() noexcept;

  const Arm& arm_;
  ConveyorConfig conveyor_;
  PlanOutbox& outbox_;
  PartStore& store_;
  SpscQueue<Part, kParts> parts_;
  std::uint32_t parts_seen_ = 0;
  bool approaching_ = false;
  std::optional<PartFollowed> missed_{};

  Part part_{};  // that is followed, or will be
  bool first_ = true;
  bool rests_ = false;  // it need not come nearer
  double begin_mm_ = 0.0;
  double planned_mm_ = 0.0;
  double speed_mm_s_ = 0.0;  // of the belt, when the planning began
  int tries_ = 0;

  ConveyorMotion motion_;
  bool check_begun_ = false;
  int pass_ = 0;
  std::int64_t checked_ticks_ = 0;  // of this pass
  AxisState assumed_{};             // of the belt, likewise
  std::uint8_t axis_ = 0;
  std::int64_t inverses_ = 0;

  std::uint32_t sent_ = 0;  // wraps like PartStore::over
};

}  // namespace armature
