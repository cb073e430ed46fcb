// The plans on their way to core 0, and what core 1 knows of those that it has sent.
//
// A plan is built of pieces, which are copied to the memory that core 0 reads.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "controller/activity/channel.hpp"
#include "controller/trajectory/plan/plan.hpp"

namespace armature {

class PlanOutbox {
 public:
  // The channel must outlive the outbox.
  explicit PlanOutbox(Channel& channel) noexcept : store_{channel.plan_store}, control_{channel.control} {}
  PlanOutbox(const PlanOutbox&) = delete;
  PlanOutbox& operator=(const PlanOutbox&) = delete;

  // For plans that need so many PieceStores.
  [[nodiscard]] bool has_room(std::size_t stores = 1) const noexcept {
    const std::uint32_t used = stores_used_ - store_.released.load(std::memory_order_acquire);
    return used + stores <= PlanStore::kPlans;
  }

  // The plan that is not sent yet. It is empty while nothing is being joined.
  [[nodiscard]] Plan& unsent() noexcept { return unsent_; }
  [[nodiscard]] const Plan& unsent() const noexcept { return unsent_; }
  // Adds a joint move, a chain or a path to it. The third piece needs room for two PieceStores.
  template <class Whole>
  void join(const Whole& whole, Ticks from, bool in_motion) noexcept {
    const std::size_t store = (next_store_ + unsent_.count / 2) % store_.pieces.size();
    unsent_.add(store_.pieces[store].keep(whole), from, in_motion);
  }
  // With room.
  void send_unsent() noexcept {
    [[maybe_unused]] const bool pushed = store_.plans.try_push(take_unsent());
    assert(pushed);
    ++queued_;
    ++sent_;
  }
  // Only where no plan is being joined, and with room.
  template <class Whole>
  void send(const Whole& whole) noexcept {
    join(whole, Ticks{}, false);
    send_unsent();
  }
  // The same for a plan that another activity sends. Its source must count what it does not read any more
  // (PlanStore::released).
  template <class Whole>
  [[nodiscard]] Plan store(const Whole& whole) noexcept {
    join(whole, Ticks{}, false);
    return take_unsent();
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
  Plan take_unsent() noexcept {
    assert(has_room(unsent_.stores()));  // the callers have checked, and only this core takes from it
    stores_used_ += static_cast<std::uint32_t>(unsent_.stores());
    next_store_ = (next_store_ + unsent_.stores()) % store_.pieces.size();
    return std::exchange(unsent_, Plan{});
  }

  PlanStore& store_;
  const RunControl& control_;
  Plan unsent_{};
  std::size_t next_store_ = 0;     // of PlanStore::pieces, the first one of unsent_
  std::uint32_t stores_used_ = 0;  // since the start; wraps like PlanStore::released
  std::uint32_t queued_ = 0;       // plans that were sent; wraps
  std::uint32_t sent_ = 0;         // plans and requests; wraps like PlanStore::over
  std::uint32_t late_ = 0;         // of PlanStore::late, those that are known here
};

}  // namespace armature
