// Executes the paths of core 1 in the frame of a part on the conveyor.
//
// The arm stands until the part has come to the point where the plan begins. Then the frame of the path takes up the
// velocity of the belt while the tool executes the path, and follows the belt until core 1 releases it: between two
// paths the tool stands in the frame of the part. After a release the frame comes to rest. When the part leaves its
// window, when the belt is too fast, when a set-point is impossible, when more than kMostMissed samples of the camera
// are missing, and at a stop, each joint makes its fastest stop.
//
// A set-point is executed kTicksToEmit ticks after it was computed, and `lead_s` later by the drives. The frame is
// where the part is expected then.
//
// A network may correct where the belt is expected. When the frame leaves the expected part by more than
// kMostDeviation_mm and the largest correction, because it cannot accelerate as the corrections want, there is none
// until the part is over.
#pragma once

#include <cstdint>

#include "controller/activity/activity_source.hpp"
#include "controller/activity/channel.hpp"
#include "controller/activity/conveyor/belt_correction.hpp"
#include "controller/activity/conveyor/belt_observation.hpp"
#include "controller/activity/conveyor/conveyor_belt.hpp"
#include "controller/activity/conveyor/conveyor_motion.hpp"
#include "controller/activity/conveyor/part_store.hpp"
#include "controller/activity/plans/move_progress.hpp"
#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/cell/conveyor_config.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/message/event.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class ConveyorSource final : public ActivitySource {
 public:
  static constexpr int kMostMissed = 3;
  static constexpr double kMostDeviation_mm = 3.0;  // and the largest correction

  // References must outlive the source. `correction`: of the expected belt; null: none.
  ConveyorSource(const RobotModel& robot, const Arm& arm, const Transform& flange_T_tool, const ConveyorConfig& config,
                 BeltSensor& sensor, Channel& channel, EventListener& events,
                 BeltCorrection* correction = nullptr) noexcept;
  ConveyorSource(const ConveyorSource&) = delete;
  ConveyorSource& operator=(const ConveyorSource&) = delete;

  // ActivitySource; it begins with a PartBegin and is fed with a PartRelease; the paths are in PartStore.
  void begin(const Request& first, const PerAxis<Radians>& stand, Ticks tick) noexcept override;
  void feed(const Request&) noexcept override { release_ = true; }
  void stop(StopKind) noexcept override { stop_ = true; }
  SetPoint& advance(Ticks tick, const RunControl::View& control) noexcept override;
  [[nodiscard]] bool over() noexcept override;
  void reset_to(const PerAxis<Radians>& position) noexcept override;
  void cut_short(Ticks tick) noexcept override;
  void cancel(Ticks tick) noexcept override;
  // Samples the belt, and drops a path or a dwell that came when the part was lost already.
  void observe(Ticks tick) noexcept override;

 private:
  enum class Phase : std::uint8_t { kOff, kWaiting, kFollowing, kLeaving, kStopping };

  void accept_orders(Ticks tick) noexcept;
  void follow_part(Ticks tick, double displacement_mm) noexcept;
  void follow(Ticks tick, const AxisState& part) noexcept;
  void report_progress(Ticks tick) noexcept;
  void end_request() noexcept;
  void sample_belt(Ticks tick) noexcept;
  [[nodiscard]] bool is_seen(Ticks tick) const noexcept;
  [[nodiscard]] double correction_mm() noexcept;
  void count_corrections() noexcept;
  void end(PartEnd end, Ticks tick, std::uint8_t axis = 0) noexcept;
  void drop_request(Ticks tick, Refusal reason) noexcept;
  void drop_next(Ticks tick, Refusal reason) noexcept;
  void brake() noexcept;
  void report(PartPhase phase, Ticks tick) noexcept;
  [[nodiscard]] AxisState part_ahead() const noexcept;

  const RobotModel& robot_;
  const ConveyorConfig& config_;
  BeltSensor& sensor_;
  PartStore& store_;
  PlanStore& plan_store_;
  EventListener& events_;
  ConveyorBelt belt_;
  BeltObservation observation_;
  BeltCorrection* correction_;
  PolicyGuard::Counts counts_at_begin_{};  // of correction_
  bool withholds_ = false;                 // corrections, until the part is over
  std::uint32_t withheld_ = 0;             // of this part
  std::uint32_t samples_ = 0;              // number of the last one
  ConveyorMotion motion_;
  Phase phase_ = Phase::kOff;
  const ConveyorRequest* request_ = nullptr;  // in the store, being executed
  double part_mm_ = 0.0;
  double begin_mm_ = 0.0;
  bool release_ = false, stop_ = false;  // were requested
  bool synchronised_ = false;
  bool request_done_ = false;  // in the last tick: its last set is being emitted
  MoveProgress progress_;      // of the plan of request_
  PartFollowed result_{};
  PerAxis<PhaseLaw> stops_{};
  std::int64_t braked_ticks_ = 0;
  int still_ticks_ = 0;
};

}  // namespace armature
