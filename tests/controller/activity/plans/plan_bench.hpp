// Plans without core 0: the test executes core 1's work and reads the plans that it sends.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "controller/activity/plans/plan_activity.hpp"
#include "tests/controller/activity/owner_bench.hpp"
#include "tests/controller/support/model_logic.hpp"

namespace armature::test {

class PlanBench : public OwnerBench {
 public:
  explicit PlanBench(const PerAxis<Radians>& start = kReady) : OwnerBench{start} {
    owner.set_activities(plans, queue, plans.retarget());
    at_rest();
  }

  // Core 1 accepts it; the refusal, if there is one, is returned.
  template <class Move>
  std::optional<MoveRefused> accept(const Move& move) {
    return plans.accept(move);
  }
  template <class... Moves>
  void accept_all(const Moves&... moves) {
    const auto accept_it = [this](const auto& move) { EXPECT_FALSE(this->accept(move).has_value()); };
    (accept_it(moves), ...);
  }
  // Until there is nothing more to do at present.
  void work() {
    while (step()) {
    }
  }

  // One step; false: there is nothing to do at present.
  bool step() {
    if (!plans.may_work()) return false;
    const PlanActivity::Work work = plans.work(bus);
    if (work != PlanActivity::Work::kNothing) return work == PlanActivity::Work::kDone;
    const MoveQueue::Move* next = queue.front();
    if (next == nullptr) return false;
    const auto execute_it = [this](const auto& move) {
      if constexpr (requires { plans.execute(move, bus); }) return plans.execute(move, bus);
      return false;
    };
    return std::visit(execute_it, *next);
  }

  // Core 0 has executed so many ticks of the last plan that it took.
  void execute(std::uint32_t ticks) { channel->plan_store.progress.set({taken_, ticks}); }
  // Core 0 takes the next plan; it stays in the queue for the test.
  void take_plan() {
    ASSERT_FALSE(channel->plan_store.plans.empty());
    ++taken_;
  }
  // The last pulse of all plans that were sent is emitted.
  void finish(std::uint32_t plans_over) {
    for (PlanStore& store = channel->plan_store; !store.plans.empty(); store.plans.drop_front()) {
      store.release(store.plans.front()->stores());
    }
    channel->plan_store.over.store(plans_over);
  }
  // Plans that were sent, and one of them.
  [[nodiscard]] std::size_t plans_sent() const {
    std::size_t count = 0;
    while (plan(count) != nullptr) ++count;
    return count;
  }
  [[nodiscard]] const Plan* plan(std::size_t index = 0) const { return channel->plan_store.plans.peek(index); }

  ModelLogic bus;
  const PlanningConfig config{};
  UserFrames frames{};
  const std::unique_ptr<PlanActivity> owned =
      std::make_unique<PlanActivity>(ActivityContext{robot, arm, config, frames, owner, queue, *channel, events});
  PlanActivity& plans = *owned;

 private:
  std::uint32_t taken_ = 0;
};

// A line of the tool by this way, from where it is then.
inline CartesianMove shift(double x_mm, double y_mm, double z_mm, double blend_mm, std::uint32_t tag) {
  return {.target = {.frame = kToolFrame, .position_mm = {x_mm, y_mm, z_mm}},
          .limits = kBrisk,
          .blend_mm = blend_mm,
          .tag = tag};
}

}  // namespace armature::test
