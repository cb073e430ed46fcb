// A client on core 1: accepts commands, refuses what cannot be done, plans the rest and hands it to the motion loop.
//
// A move is checked when it arrives and planned from where the move before it ends, so plans follow each other without
// a pause and planning goes on while the arm moves. What only planning shows (a pose out of reach, a path that a joint
// cannot follow, a move that would take too long) refuses the move then; those after it are planned from where the arm
// will stand without it. Poses are resolved at that time too: "tool" is where the tool will be.
//
// Paths are planned in slices of kSlice inverse kinematics, and at most PathPass::kMostInverses more, and commands are
// accepted between any two of them, so no Stop or Hold waits for a long check. Stop and ClearFault overtake waiting
// moves; what is planned after them starts where the arm then stands.
//
// Commands for the pins of the tool wait among the moves (command.hpp says for what); what is behind them is planned
// after them. Core 1 sleeps while it waits for an input: it wakes up for the interrupt of the GPIO, and in each tick
// when the wait has a time-out.
//
// Cartesian moves become one chain (chain.hpp) as long as they arrive before its planning has ended; the planning then
// begins again.
//
// No move is lost silently: each one is started or reported as refused, those that a Stop or a fault drops included. Of
// a refused chain the segment to blame has the reason, the others kChainRefused.
#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>

#include "controller/command/chain.hpp"
#include "controller/command/command.hpp"
#include "controller/command/core1_client.hpp"
#include "controller/command/inbox.hpp"
#include "controller/command/planning_config.hpp"
#include "controller/command/tool_io.hpp"
#include "controller/core/axes.hpp"
#include "controller/core/spsc_queue.hpp"
#include "controller/core/units.hpp"
#include "controller/event/event.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/motion/mailbox.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/plan/cartesian_planner.hpp"

namespace armature {

class Dispatcher final : public Core1Client {
 public:
  static constexpr std::size_t kWaitingMoves = 16;
  static constexpr std::int64_t kSlice = 100;  // 0.3 ms where an inverse kinematics takes 3 us

  // References must outlive the dispatcher.
  Dispatcher(const RobotModel& robot, const Arm& arm, const PlanningConfig& config, Inboxes& inboxes,
             MotionMailbox& mailbox, ToolIo& tool, EventListener& events) noexcept;
  Dispatcher(const Dispatcher&) = delete;
  Dispatcher& operator=(const Dispatcher&) = delete;

  // Core1Client
  [[nodiscard]] bool execute(RegisterBus& bus) noexcept override;
  [[nodiscard]] bool waits_for_time() const noexcept override { return tool_.timed(); }

 private:
  enum class Mode : std::uint8_t {
    kAwaitingRest,  // the motion loop will say where the arm stands; moves wait
    kReady,         // planned_end_ is where the next plan starts
    kFault,         // moves are refused
    kUnusable,      // so is ClearFault: nobody would answer it
  };

  struct WaitingMove {
    std::variant<JointMove, PoseMove, CartesianMove, SetOutput, WaitInput> move;
    bool follows = false;  // none was refused between it and the one accepted before
  };

  void on_news(const MotionNews& news) noexcept;
  template <class Move>
  void accept(const Move& move) noexcept;
  void accept(const Hold& hold) noexcept;
  void accept(const Resume& resume) noexcept;
  void accept(const SetOverride& wanted) noexcept;
  void accept(const Stop& stop) noexcept;
  void accept(const ClearFault& clear) noexcept;
  void order(MotionOrder order) noexcept;
  void drop_moves() noexcept;
  void drop_waiting(Refusal reason) noexcept;
  void refuse(Refusal reason, Tag tag) noexcept;

  // One step through what waits; false when there is nothing to do, no room for a plan, or something to wait for.
  bool plan_on(RegisterBus& bus) noexcept;
  template <class Move>
  bool execute(const Move& move, RegisterBus& bus) noexcept;
  bool execute(const SetOutput& output, RegisterBus& bus) noexcept;
  bool execute(const WaitInput& wait, RegisterBus& bus) noexcept;
  // The arm stands at the end of all plans, and not because of a Hold.
  [[nodiscard]] bool stands() const noexcept;
  void hand_over(const MotionPlan& plan) noexcept;
  // `residual_rad`: by how much the orientation that was asked for is missed, see MoveStarted.
  void plan(const JointMove& move, RegisterBus& bus, double residual_rad = 0.0) noexcept;
  void plan(const PoseMove& move, RegisterBus& bus) noexcept;
  void plan(const CartesianMove& move, RegisterBus& bus) noexcept;
  void plan_chain(RegisterBus& bus) noexcept;
  void work_on_chain(RegisterBus& bus) noexcept;
  [[nodiscard]] bool extend_chain() noexcept;
  void refuse_chain(const PathProblem& problem) noexcept;
  [[nodiscard]] Transform planned_tool_pose() const noexcept;

  const RobotModel& robot_;
  const Arm& arm_;
  const PlanningConfig& config_;
  Inboxes& inboxes_;
  MotionMailbox& mailbox_;
  ToolIo& tool_;
  EventListener& events_;
  Mode mode_ = Mode::kAwaitingRest;
  PerAxis<Radians> planned_end_{};
  SpscQueue<WaitingMove, kWaitingMoves> waiting_;  // accepted, not yet being planned
  bool gap_ = false;                               // a move has been refused since the last one was accepted
  Tag clear_tag_{};                                // of the ClearFault that is not answered
  ArmPlane plane_;                                 // with the tool
  Chain chain_;                                    // being planned
  CartesianPlanner planner_;
  std::uint32_t plans_sent_ = 0;  // wraps like MotionMailbox::plans_over
};

}  // namespace armature
