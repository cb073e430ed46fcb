// The plans that core 0 has, and how far it is with them.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "controller/base/spsc_queue.hpp"
#include "controller/trajectory/plan/plan.hpp"

namespace armature {

struct PlanStore {
  static constexpr std::size_t kPlans = 9;  // PieceStores of plans that were sent, the active one included
  // All moves of these plans. Only the active plan and the one that continues it may have more than
  // CartesianPlan::kMaxFirstSegments.
  static_assert(Plan::kMaxMoves == CartesianPlan::kMaxFirstSegments);
  static constexpr std::size_t kMoves = kPlans * CartesianPlan::kMaxFirstSegments + 2 * CartesianPlan::kMaxSegments;

  // Core 1 -> core 0. Each begins where the previous one ends, or continues it (CartesianPlan::continues): then it is
  // sent when that one is active, and no other plan behind it before it has replaced that one or was too late.
  SpscQueue<Plan, kPlans> plans;
  // What their pieces name, in the order of the plans; core 1 fills one more for the plan that it has not sent. While
  // the arm follows a part on the conveyor, its paths and dwells are here.
  std::array<PieceStore, kPlans + 1> pieces{};
  // Core 0 -> core 1: number of PieceStores that core 0 does not read any more, since the start; wraps. Those of a plan
  // that is dropped behind the active one are free when those of that are.
  std::atomic<std::uint32_t> released{0};
  void release(std::size_t stores) noexcept {
    released.fetch_add(static_cast<std::uint32_t>(stores), std::memory_order_release);
  }
  JointChain retarget;  // of core 0, which plans the move that begins at once

  // Core 0 -> core 1, with an event: number of plans and RetargetRequests that are over, since the start;
  // wraps. A plan is over when its last pulse is emitted, at its end or where a stop or a fault ended it, or when it
  // was dropped.
  std::atomic<std::uint32_t> over{0};
  // Core 0 -> core 1, in every tick of a plan: how far the arm is.
  class PlanProgress {
   public:
    struct View {
      std::uint32_t plan = 0;   // its number of all that `plans` had, from 1; 0: none of these; wraps
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
  std::atomic<std::uint32_t> late{0};
};

}  // namespace armature
