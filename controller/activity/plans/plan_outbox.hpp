// The plans on their way to core 0, and what core 1 knows of those that it has sent.
//
// A plan is built in its place in the queue, because it has no room on the stack.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "controller/activity/channel.hpp"
#include "controller/trajectory/plan/motion_plan.hpp"

namespace armature {

class PlanOutbox {
 public:
  // The channel must outlive the outbox.
  explicit PlanOutbox(Channel& channel) noexcept : store_{channel.plan_store}, control_{channel.control} {
    joined().begin_joined();
  }
  PlanOutbox(const PlanOutbox&) = delete;
  PlanOutbox& operator=(const PlanOutbox&) = delete;

  [[nodiscard]] bool has_room(std::size_t plans = 1) const noexcept { return store_.plans.has_room(plans); }
  // Only where no plan is being joined, and with room.
  template <class Plan>
  void send(const Plan& plan) noexcept {
    joined() = plan;
    send_entries(1);
  }

  // The plan of paths and joint moves that is not sent yet. It has no parts while nothing is joined.
  [[nodiscard]] MotionPlan& joined() const noexcept { return store_.plans.free_slot(); }
  // Adds a part to joined(). The third one needs room for a second entry.
  template <class Plan>
  void join(const Plan& plan, Ticks from, bool in_motion) noexcept {
    if (joined().parts() + 1 < MotionPlan::kMaxParts) return joined().add(plan, from, in_motion);
    MotionPlan& next = store_.plans.free_slot(1);
    next = plan;
    joined().add_next_of_queue(next, from, in_motion);
  }
  void send_joined() noexcept {
    if (joined().parts() == 1) joined().become_path();
    send_entries(joined().entries());
  }

  // A joint move that begins at once counts like a plan.
  void count_retarget() noexcept { ++sent_; }

  // The last pulse of all plans is emitted.
  [[nodiscard]] bool all_over() const noexcept { return store_.over.load(std::memory_order_acquire) == sent_; }
  // No Hold keeps the arm from moving.
  [[nodiscard]] bool stands() const noexcept { return all_over() && !control_.view().hold; }
  // The last plan is being executed: the ticks of its own time that are over. Before: -1.
  [[nodiscard]] double ticks_of_last() const noexcept {
    const PlanStore::PlanProgress::View progress = store_.progress.view();
    return progress.plan == queued_ ? progress.ticks : -1.0;
  }
  // True once for each plan that came too late to continue the one before. Core 0 has dropped it.
  [[nodiscard]] bool take_late() noexcept {
    if (store_.late.load(std::memory_order_acquire) == late_) return false;
    ++late_;
    return true;
  }

 private:
  void send_entries(std::size_t entries) noexcept {
    assert(store_.plans.has_room(entries));  // the callers have checked, and only this core fills the queue
    store_.plans.push_slots(entries);
    queued_ += static_cast<std::uint32_t>(entries);
    ++sent_;
    joined().begin_joined();
  }

  PlanStore& store_;
  const RunControl& control_;
  std::uint32_t queued_ = 0;  // entries of PlanStore::plans that were sent; wraps
  std::uint32_t sent_ = 0;    // plans and requests; wraps like PlanStore::over
  std::uint32_t late_ = 0;    // of PlanStore::late, those that are known here
};

}  // namespace armature
