// The only way between the cores. Core 1 sends requests to core 0, which answers and reports events. States and large
// plans are words and stores beside the queues.
//
// Only the activity that has the arm is fed. kBegin is sent only while the arm stands or the same activity has it.
// Every kBegin and kStop is answered: by kRest when plans have the arm again, or by kFault. A stop whose activity is
// over already is answered at once. An answer covers all requests up to its number; core 1 ignores a kRest that does
// not cover its newest one.
//
// No queue fills up, although either core may sleep for any time:
//   requests  Core 0 empties them in each tick. Unread are at most 16 set-points of a stream, 2 commands of a jog, or
//             one request of another activity. Besides, a release and three stops of the present motion, each stronger
//             than the one before. And one order, which is sent only when everything before it was answered.
//   answers   Two begins, three stops, a joint move that begins at once, and a fault.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>

#include "controller/activity/conveyor/part_store.hpp"
#include "controller/activity/plans/plan_store.hpp"
#include "controller/activity/request.hpp"
#include "controller/base/axes.hpp"
#include "controller/base/spsc_queue.hpp"
#include "controller/message/event.hpp"
#include "controller/motion/loop_channel.hpp"
#include "controller/motion/run_control.hpp"

namespace armature {

struct Channel {
  static constexpr std::size_t kRequests = 24;
  static constexpr std::size_t kJogs = 2;     // unread commands
  static constexpr std::size_t kStream = 16;  // unread set-points
  static constexpr std::size_t kOrders = 2;   // a switch-off and a clear fault, each answered before the next
  // Between two reads of this queue by core 1 at most one plan is added to those of core 0. Each move causes at most
  // two events, its start and its end, and each plan one for each of its outputs. A joint move that begins at once and
  // each jog cause two, a stream one, a followed part four. Homing causes two for each axis. Core 0 enters and leaves
  // Fault at most once for each order.
  static constexpr std::size_t kEvents = 2 * (PlanStore::kMoves + CartesianPlan::kMaxSegments + PartStore::kMoves) +
                                         TimedOutputs::kMax * (PlanStore::kPlans + 2) + 2 * (1 + kJogs + 1) +
                                         2 * (kOrders + 1) + 1 + 4 + 2 * kAxes;

  RunControl control;  // core 1 -> core 0; a kStop is sent before the hold that it ends is released
  SpscQueue<Request, kRequests> requests;
  LoopChannel loop;
  PlanStore plan_store;
  PartStore part_store;
  SpscQueue<Event, kEvents> events;  // core 0 -> core 1, with an event

  // Core 1: not more than `most` requests are unread.
  [[nodiscard]] bool has_unread_at_most(std::size_t most) const noexcept { return requests.has_room(kRequests - most); }
  // Core 1. `fill(Request&)` sets the content.
  template <class Fill>
  void send(Request::Kind kind, ActivityId to, std::uint32_t number, Fill fill) noexcept {
    assert(requests.has_room(1));  // see above
    Request& request = requests.free_slot();
    request.kind = kind;
    request.to = to;
    request.number = number;
    fill(request);
    requests.push_slot();
  }
};

}  // namespace armature
