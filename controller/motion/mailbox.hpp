// What the two cores send each other: plans, orders and the wanted rate to the motion loop; news and events back. Each
// kind has its own queue; hold, override and how far the plans have come are words beside them, which cannot fill up.
#pragma once

#include <atomic>
#include <cstdint>

#include "controller/core/axes.hpp"
#include "controller/core/spsc_queue.hpp"
#include "controller/core/units.hpp"
#include "controller/event/event.hpp"
#include "controller/motion/run_control.hpp"
#include "controller/trajectory/plan/motion_plan.hpp"

namespace armature {

// Overtakes all plans.
enum class MotionOrder : std::uint8_t {
  kStop,        // drop all plans, brake on the path; answered by kAtRest, not at all in Fault
  kClearFault,  // leave Fault; answered by kAtRest or, when the cause is still there, by kFaultStays. Only in Fault
};

struct MotionNews {
  enum class Kind : std::uint8_t {
    kAtRest,      // stands at `position` with nothing to do: ready for plans that begin there
    kFault,       // has entered Fault; all plans are dropped
    kFaultStays,  // kClearFault was of no use
    kUnusable,    // in Fault for good, the core sleeps: no order will be answered
  };
  Kind kind = Kind::kFault;
  PerAxis<Radians> position{};
};

// Neither orders nor news can fill up, although core 1 may sleep for any time. After an order core 1 sends no other one
// before it has received kAtRest or a kind of fault, and it reads all news before it orders. So unread there are at
// most
//   orders  a kStop that met a Fault, and the kClearFault after it;
//   news    one answer (or the kAtRest of the start), and one kFault: after it only kClearFault brings more news, and
//           that is sent only when both have been read.
struct MotionMailbox {
  static constexpr std::size_t kPlans = 8;
  static constexpr std::size_t kOrders = 2;
  static constexpr std::size_t kNews = 2;
  // Between two looks of core 1 into this queue at most one plan is added to those that core 0 has. Each move gives at
  // most two events, it starts and finishes; and core 0 enters and leaves Fault at most once for each order.
  static constexpr std::size_t kEvents = 2 * (kPlans + 2) * CartesianPlan::kMostSegments + 2 * (kOrders + 1);

  RunControl control;  // core 1 -> core 0. A kStop is pushed before the hold that it ends is released

  // Core 0 -> core 1, which is woken by an event: plans of `plans` that are over, since the start and wrapping. A plan
  // is over when its last pulse is out, be it the end or where a stop or a fault left it, or when it was dropped.
  std::atomic<std::uint32_t> plans_over{0};
  // Core 1 -> core 0: it waits for time to pass and is woken by an event in every tick outside Fault.
  std::atomic<bool> wake_each_tick{false};

  SpscQueue<MotionPlan, kPlans> plans;     // core 1 -> core 0, each begins where the one before ends
  SpscQueue<MotionOrder, kOrders> orders;  // core 1 -> core 0
  SpscQueue<Event, kEvents> events;        // core 0 -> core 1, which is woken by an event
  SpscQueue<MotionNews, kNews> news;       // core 0 -> core 1, which is woken by an event; also when a plan is taken
};

}  // namespace armature
