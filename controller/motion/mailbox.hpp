// The data exchange between the two cores. Core 1 sends plans, orders and the wanted rate to the motion loop; core 0
// sends notices and events back. Each kind has its own queue. Hold, override and the number of finished plans are words
// beside the queues, which cannot fill up.
#pragma once

#include <atomic>
#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/spsc_queue.hpp"
#include "controller/base/units.hpp"
#include "controller/message/event.hpp"
#include "controller/motion/arm_position.hpp"
#include "controller/motion/conveyor_request.hpp"
#include "controller/motion/homing_request.hpp"
#include "controller/motion/retarget_request.hpp"
#include "controller/motion/run_control.hpp"
#include "controller/motion/stream_sample.hpp"
#include "controller/motion/velocity_input.hpp"
#include "controller/trajectory/plan/motion_plan.hpp"

namespace armature {

// An order overtakes all plans.
enum class MotionOrder : std::uint8_t {
  kStop,        // drop all plans, brake on the path; answered by kAtRest, not answered in Fault
  kSwitchOff,   // sent only when the arm stands without a plan: enter Fault with the cause kDrivesOff
  kClearFault,  // leave Fault; answered by kAtRest, or by kFaultPersists when the cause persists. Sent only in Fault
};

struct MotionNotice {
  enum class Kind : std::uint8_t {
    kAtRest,         // stands at `position` without a plan: ready for plans that begin there
    kFault,          // entered Fault; all plans are dropped
    kFaultPersists,  // kClearFault had no effect
    kUnusable,       // in Fault for good, core 0 sleeps: it will answer no order
    kRetargeted,     // the RetargetRequest is the active plan, which ends at `position`; all earlier plans are dropped
    kNotRetargeted,  // the RetargetRequest was refused, and all earlier plans continue
  };
  Kind kind = Kind::kFault;
  PerAxis<Radians> position{};
  std::uint32_t jogs = 0;       // MotionMailbox::jogs_accepted at that time
  std::uint8_t referenced = 0;  // mask of axes whose joint angles are known at that time
};

// The queues of orders and notices cannot fill up, although core 1 may sleep for any time. After an order core 1 sends
// no other one before it has received kAtRest or a fault, and it reads all notices before it sends an order. So the
// unread entries are at most
//   orders   a kStop that arrived in Fault, and the kClearFault after it;
//   notices  one answer (or the kAtRest of the start), and one kFault. After kFault only kClearFault causes more
//            notices, and it is sent only when both have been read. Besides, a kAtRest for each accepted jog command:
//            core 1 sends one after it has read all notices, and until then at most kJogs wait. And the answer to the
//            RetargetRequest, of which core 1 sends one after it has read that to the previous one.
struct MotionMailbox {
  static constexpr std::size_t kPlans = 9;  // entries; the active plan included
  // All moves of these plans. Only the active plan and the one that continues it may have more than
  // CartesianPlan::kMaxFirstSegments.
  static_assert(MotionPlan::kMaxMoves == CartesianPlan::kMaxFirstSegments);
  static constexpr std::size_t kMoves = kPlans * CartesianPlan::kMaxFirstSegments + 2 * CartesianPlan::kMaxSegments;
  static constexpr std::size_t kOrders = 2;
  static constexpr std::size_t kJogs = 2;
  static constexpr std::size_t kStreamStops = 2;  // of a stream: a soft one and a quick one
  static constexpr std::size_t kStream = 16 + kStreamStops;
  static constexpr std::size_t kRetargets = 1;
  static constexpr std::size_t kHomings = 2;
  static constexpr std::size_t kNotices = 2 + kJogs + kRetargets + 1;
  // Between two reads of this queue by core 1 at most one plan is added to those of core 0. Each move causes at most
  // two events, its start and its end, and each plan one for each of its outputs. The request of `retargets` and each
  // jog, which begins with a command of `jogs`, cause two. A stream causes one, a followed part four. Homing causes two
  // for each axis. Core 0 enters and
  // leaves Fault at most once for each order.
  static constexpr std::size_t kEvents = 2 * (kMoves + CartesianPlan::kMaxSegments + ConveyorMailbox::kMoves) +
                                         TimedOutputs::kMax * (kPlans + 2) + 2 * (kRetargets + kJogs + 1) +
                                         2 * (kOrders + 1) + 1 + 4 + 2 * kAxes;

  RunControl control;  // core 1 -> core 0; a kStop is pushed before the hold that it ends is released

  // Core 0 -> core 1, with an event: number of entries of `plans` and `retargets` that are over, since the start;
  // wraps. A plan is over when its last pulse is emitted, at its end or where a stop or a fault ended it, or when it
  // was dropped.
  std::atomic<std::uint32_t> plans_over{0};
  // Core 0 -> core 1, in every tick of a plan: how far the arm is.
  class PlanProgress {
   public:
    struct View {
      std::uint32_t plan = 0;   // number of its last entry of all that `plans` had, from 1; 0: none yet; wraps
      std::uint32_t ticks = 0;  // of its own time that are over
    };
    void set(const View& view) noexcept {
      word_.store(static_cast<std::uint64_t>(view.plan) << 32 | view.ticks, std::memory_order_release);
    }
    [[nodiscard]] View view() const noexcept {
      const std::uint64_t word = word_.load(std::memory_order_acquire);
      return {static_cast<std::uint32_t>(word >> 32), static_cast<std::uint32_t>(word)};
    }

   private:
    std::atomic<std::uint64_t> word_{0};
    static_assert(std::atomic<std::uint64_t>::is_always_lock_free);
  };
  PlanProgress progress;
  // Core 0 -> core 1, with an event: number of plans that came too late to continue the active one, since the start;
  // wraps. Their moves are not reported, because core 1 sends them again.
  std::atomic<std::uint32_t> plans_late{0};
  ArmPosition position;  // core 0 -> core 1, in every tick
  // Core 1 -> core 0: core 1 waits for time to pass and must be woken by an event in every tick.
  std::atomic<bool> wake_each_tick{false};

  // Core 1 -> core 0. Each begins where the previous one ends, or continues it (CartesianPlan::continues): then it is
  // sent when that one is active, and no other plan behind it before it has replaced that one or was too late. The
  // active plan stays in the queue until its end, so no plan is copied. A joined plan of three parts takes two
  // entries, which enter and leave the queue together.
  SpscQueue<MotionPlan, kPlans> plans;
  SpscQueue<MotionOrder, kOrders> orders;  // core 1 -> core 0
  // Core 1 -> core 0. Replaces the active plan and all of `plans`, in the next tick without a hold, if a motion within
  // the limits leads there. Core 1 sends no plan before it has received kRetargeted, kNotRetargeted, kAtRest or a
  // fault.
  SpscQueue<RetargetRequest, kRetargets> retargets;
  MotionPlan retarget_plan;  // of core 0, which plans the request; its stack has no room for a plan
  // Core 1 -> core 0. The first one is sent when the arm stands at the end of all plans; the jog ends with a kAtRest
  // whose `jogs` counts all that were sent. No plan and no order is sent before.
  SpscQueue<VelocityCommand, kJogs> jogs;
  std::uint32_t jogs_accepted = 0;  // of core 0 only: number of jog commands that it read, since the start; wraps
  // Core 1 -> core 0. The first set-point is sent when the arm stands at the end of all plans; the stream ends with a
  // kAtRest. Nothing else is sent before. A set-point for which there is no room is missing; a stop always has room.
  SpscQueue<StreamSample, kStream> stream;
  // Core 1 -> core 0. Sent when the arm stands at the end of all plans; homing ends with a kAtRest. Only one to stop it
  // is sent before, which has no effect later.
  SpscQueue<HomingRequest, kHomings> homings;
  ConveyorMailbox conveyor;
  SpscQueue<Event, kEvents> events;  // core 0 -> core 1, with an event
  SpscQueue<MotionNotice, kNotices>
      notices;  // core 0 -> core 1, with an event; an event also comes when a plan is popped
};

}  // namespace armature
