// What core 1 and core 0 exchange about the conveyor.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "controller/base/spsc_slot.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/plan/plan.hpp"

namespace armature {

// A path of at most CartesianPlan::kMaxFirstSegments segments that core 0 executes in the frame of a part, or a dwell
// there. The first one is a path. It begins to follow the part when the displacement of the part has reached begin_mm.
struct ConveyorRequest {
  Plan plan{};              // a path, or a joint move that is a dwell, in PlanStore::pieces
  double planned_mm = 0.0;  // of a path: displacement of the frame for which it was planned
  bool first = false;
  // Of the first one.
  double part_mm = 0.0;   // position of the belt when the part passed the sync point
  double begin_mm = 0.0;  // the frame stands at planned_mm then
  std::uint32_t part = 0;
};

// What a Request says; the paths and dwells are in PartStore.
struct PartBegin {};    // follow the part of the first path
struct PartRelease {};  // the path is done: the frame comes to rest

struct PartStore {
  // Of the present request and one that was over before core 1 read its events.
  static constexpr std::size_t kMoves = 2 * CartesianPlan::kMaxFirstSegments;

  // Core 1 -> core 0: the content of a Request. Each one is sent when the one before is over, so there is room for one.
  SpscSlot<ConveyorRequest> request;
  // Core 0 -> core 1, with an event: number of requests that are over, since the start; wraps.
  std::atomic<std::uint32_t> over{0};
  // Core 0 -> core 1: the belt in the latest tick. The two may be of neighbouring ticks.
  std::atomic<double> belt_mm{0.0};
  std::atomic<double> belt_mm_s{0.0};
};

}  // namespace armature
