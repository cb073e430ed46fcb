// Joint moves that are being planned into one chain, because each leads to the next without a stop. The chain is sent
// when no other move joins it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "controller/activity/activity_context.hpp"
#include "controller/activity/plans/stages/plan_outbox.hpp"
#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/message/command.hpp"
#include "controller/trajectory/joint/joint_chain.hpp"
#include "controller/trajectory/joint/joint_move.hpp"
#include "controller/trajectory/plan/corner_planner.hpp"

namespace armature {

class JointStage {
 public:
  // References must outlive the stage.
  JointStage(const ActivityContext& context, PlanOutbox& outbox) noexcept : context_{context}, outbox_{outbox} {}

  [[nodiscard]] bool empty() const noexcept { return chain_.count == 0; }
  [[nodiscard]] std::size_t count() const noexcept { return chain_.count; }
  [[nodiscard]] JointChain& chain() noexcept { return chain_; }
  // The last move leads to another one, and the chain has room for it.
  [[nodiscard]] bool open() const noexcept { return open_ && chain_.count < JointChain::kMaxMoves; }
  [[nodiscard]] bool leads_on() const noexcept { return open_; }
  void close() noexcept { open_ = false; }
  [[nodiscard]] bool has_outputs() const noexcept;

  // Of the last move, for the corner between it and a path.
  [[nodiscard]] const JointMove& last() const noexcept { return last_; }
  [[nodiscard]] const PerAxis<Radians>& start_of_last() const noexcept { return via_; }
  [[nodiscard]] double blend_before_last_rad() const noexcept { return blend_rad_; }

  // Sends a joint move that joins nothing.
  void send_alone(const JointMove& move, RegisterBus& bus, double residual_rad) noexcept;
  // Plans a move behind those of the chain. False, and the chain stays as it is: the move would take too long.
  [[nodiscard]] bool plan(const JointMove& move, RegisterBus& bus) noexcept;
  // The chain begins with a move that leaves a path in motion.
  void begin(const Departure& departure) noexcept;
  // The move is now the last one of the chain. `open`: another one may follow.
  void add(const JointMove& move, double residual_rad, bool open) noexcept;

  // Sends the chain as a plan of its own, or refuses it if an output is outside.
  void send() noexcept;
  void clear() noexcept { chain_.count = 0; }
  void drop(Refusal why) noexcept;

 private:
  [[nodiscard]] JointPlan only_move() const noexcept;
  void refuse(std::size_t to_blame) noexcept;

  ActivityContext context_;
  PlanOutbox& outbox_;
  JointChain chain_;
  std::array<PathOutputs, JointChain::kMaxMoves> outputs_{};  // of the moves of chain_
  JointMove last_{};
  PerAxis<Radians> start_{};  // of the chain
  PerAxis<Radians> via_{};    // where the last move begins
  double blend_rad_ = 0.0;    // of the corner there between joint moves
  bool open_ = false;
};

}  // namespace armature
