// A client on core 1: accepts commands, refuses those that cannot be executed, plans the others and sends the plans to
// core 0.
//
// A move is checked when it arrives. It is planned from the end of the previous move, so plans follow each other
// without a pause, and planning continues while the arm moves. Some errors show only in planning: a pose out of reach,
// a path that a joint cannot follow, a move that would take too long. The move is then refused, and the moves after it
// are planned from where the arm will stand without it. Poses are resolved at planning time too: the frame "tool" is
// the tool's pose at the start of the move.
//
// Paths are planned in slices of kSlice inverse kinematics, plus at most PathPass::kMaxInverses. Commands are accepted
// between two slices, so a Stop or a Hold never waits for a long check. Stop and ClearFault overtake waiting moves. The
// next plan then starts where the arm stands. The corners between paths and joint moves are planned in steps, likewise
// (kMostOfStep).
//
// Commands for the tool's pins wait in the same queue as the moves (see command.hpp). The moves behind them are planned
// after they are executed. Core 1 sleeps while it waits for an input: the GPIO interrupt wakes it up, and so does each
// tick when the wait has a time-out.
//
// Joint moves with a blend are planned into one chain, a move at a time, and sent when no other one joins it.
//
// Cartesian moves are added to one chain (chain.hpp) while its planning has not ended. The planning then starts again.
//
// A path and joint moves, in either order, are joined where the first move of both has a blend: what is planned waits
// until the other one is planned, too, and is sent with it as one plan. A chain of paths is joined only if the plan
// then has at most MotionPlan::kMaxMoves moves, so a window never is.
//
// A joint move that begins at once is planned by core 0. Planning stops until core 0 has answered; then the moves that
// came before are dropped, or continue when it was refused.
//
// A long chain is planned in windows (dispatcher_window.cpp): its first moves as above, the others in plans that
// continue the one before while the arm executes it. So the moves of a chain are never planned more than a window
// ahead, and the moves of Source::kProgram wait in their inbox until there is room. A window is sent early enough
// before the arm would brake. If the moves come too late, the arm brakes on the path, and goes on from where it stops.
// If they came in time and their planning did not, this is a stop that nobody asked for (MoveStarted::unasked_stop).
//
// A jog is no plan: its commands go to core 0 at once, the latest of each execute(), and moves wait until core 0
// reports where the arm stands after the jog.
//
// The set-points of a stream go to core 0 at once, too (stream_feed.hpp), and so does a request to home axes. Core 0
// reports with each rest which joint angles are known. If one is not, whatever waits is refused
// (dispatcher_homing.cpp).
//
// Paths in the frame of a part on the conveyor are planned, then checked on the moving belt (conveyor_feed.hpp). Core 0
// follows the part from the first one on, until it is released for the first move in another frame. Such a chain is one
// plan and no window, and begins when the arm stands.
//
// Every move is either started or reported as refused, including those that a Stop or a fault drops. When a chain is
// refused, the segment that causes it is reported with its reason, the others with kChainRefused.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>

#include "controller/base/axes.hpp"
#include "controller/base/spsc_queue.hpp"
#include "controller/base/units.hpp"
#include "controller/cell/planning_config.hpp"
#include "controller/command/chain.hpp"
#include "controller/command/conveyor_feed.hpp"
#include "controller/command/core1_client.hpp"
#include "controller/command/inbox.hpp"
#include "controller/command/planning_cost.hpp"
#include "controller/command/stream_feed.hpp"
#include "controller/command/tool_io.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/message/command.hpp"
#include "controller/message/event.hpp"
#include "controller/motion/mailbox.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/plan/cartesian_planner.hpp"
#include "controller/trajectory/plan/corner_planner.hpp"
#include "controller/trajectory/plan/joint_chain.hpp"
#include "controller/trajectory/plan/motion_plan.hpp"

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

  // Where the arm stands when all commands are over and nothing holds it; otherwise nothing.
  [[nodiscard]] std::optional<PerAxis<Radians>> rest() const noexcept;

  // Core1Client
  [[nodiscard]] bool execute(RegisterBus& bus) noexcept override;
  [[nodiscard]] bool waits_for_time() const noexcept override {
    const bool in_window = window_ == Window::kSent || (window_ == Window::kOpen && !chain_.empty());
    return tool_.has_timeout() || in_window || conveyor_.waits_for_time();
  }

 private:
  enum class Mode : std::uint8_t {
    kAwaitingRest,  // waits for the motion loop to report the rest position; moves wait
    kReady,         // planned_end_ is where the next plan starts
    kFollowing,     // core 0 follows a part on the conveyor; planned_end_ is in the frame of the plans
    kRetargeting,   // waits for the answer to a RetargetRequest; moves wait
    kFault,         // moves are refused
    kUnusable,      // ClearFault is refused as well, because core 0 would not answer it
  };

  // Whether the last plan that was sent can be continued.
  enum class Window : std::uint8_t {
    kNone,
    kOpen,     // it can; chain_ has the moves that follow
    kSent,     // the plan that continues it was sent, with the first `window_moves_` moves of chain_
    kDropped,  // the same, and a stop or a fault ends both
  };

  struct WaitingMove {
    std::variant<JointMove, PoseMove, CartesianMove, Dwell, SetOutput, WaitInput> move;
    bool follows = false;         // no move was refused between it and the previously accepted one
    std::uint32_t retargets = 0;  // value of retargets_accepted_ when it came
  };

  void on_notice(const MotionNotice& notice) noexcept;
  template <class Move>
  void accept(const Move& move) noexcept;
  // A joint move that begins at once.
  [[nodiscard]] std::optional<MoveRefused> accept_now(const JointMove& move) noexcept;
  [[nodiscard]] bool push(const WaitingMove& move) noexcept;
  void accept(const Jog& jog) noexcept;
  void accept(const StreamPoint& point) noexcept;
  void accept(const Home& home) noexcept;
  void accept(const ConveyorPart& part) noexcept;
  void accept(const Hold& hold) noexcept;
  void accept(const Resume& resume) noexcept;
  void accept(const SetOverride& wanted) noexcept;
  void accept(const Stop& stop) noexcept;
  void accept(const ClearFault& clear) noexcept;
  void accept(const SwitchOff& off) noexcept;
  void order(MotionOrder order) noexcept;
  void end_jog(VelocityCommand::Kind how) noexcept;
  void end_homing() noexcept;
  void on_referenced(std::uint8_t axes) noexcept;
  void send_jog() noexcept;
  void send_retarget() noexcept;
  void on_retargeted(const PerAxis<Radians>& target) noexcept;
  void drop_moves(Refusal reason = Refusal::kNotReady) noexcept;
  void drop_chain(Refusal reason) noexcept;
  void drop_program() noexcept;
  void drop_waiting(Refusal reason) noexcept;
  void drop_first_waiting(Refusal reason) noexcept;
  void refuse(Refusal reason, Tag tag) noexcept;

  // Executes one step of the waiting work; false when there is none, no room for a plan, or something to wait for.
  bool execute_next(RegisterBus& bus) noexcept;
  template <class Move>
  bool execute(const Move& move, RegisterBus& bus) noexcept;
  bool execute(const CartesianMove& move, RegisterBus& bus) noexcept;
  bool execute(const Dwell& dwell, RegisterBus& bus) noexcept;
  bool execute(const SetOutput& output, RegisterBus& bus) noexcept;
  bool execute(const WaitInput& wait, RegisterBus& bus) noexcept;
  // True when the arm stands at the end of all plans and no Hold is active.
  [[nodiscard]] bool stands() const noexcept;
  // Only where no plan is being joined.
  template <class Plan>
  void send_plan(const Plan& plan) noexcept;
  // Sends the plan that joined() has become, with so many entries of the queue.
  void send_entries(std::size_t entries) noexcept;
  // `residual_rad`: error of the achieved orientation, see MoveStarted.
  void plan(const JointMove& move, RegisterBus& bus, double residual_rad = 0.0) noexcept;
  void plan(const PoseMove& move, RegisterBus& bus) noexcept;
  void plan(const Dwell& dwell, RegisterBus& bus) noexcept;
  void plan(const CartesianMove& move, RegisterBus& bus) noexcept;
  bool extend_or_send_joints(RegisterBus& bus) noexcept;
  void add_to_joints(const JointMove& move, RegisterBus& bus, double residual_rad) noexcept;
  void end_adding(const JointMove& move, double residual_rad) noexcept;
  void refuse_joint_move(Tag tag) noexcept;
  void refuse_joints(std::size_t to_blame) noexcept;
  // Joint moves and paths in one plan: dispatcher_corners.cpp.
  [[nodiscard]] JointPlan only_joint_move() const noexcept;
  void work_on_corner(RegisterBus& bus) noexcept;
  void begin_departure(const JointMove& move, double residual_rad) noexcept;
  void end_departure() noexcept;
  // The joined plan that is not sent yet, in the place of the queue where the next plan goes; joints_ and chain_ come
  // after it. It has no parts while nothing is joined.
  [[nodiscard]] MotionPlan& joined() const noexcept { return mailbox_.plans.free_slot(); }
  void send_joints() noexcept;
  [[nodiscard]] bool has_room_for_chain() const noexcept;
  [[nodiscard]] bool can_join_path() const noexcept;
  // Adds a part to joined().
  template <class Plan>
  void join(const Plan& plan, Ticks from, bool in_motion) noexcept;
  void join_path() noexcept;
  void begin_arrival() noexcept;
  void end_arrival() noexcept;
  void add_path(Ticks from) noexcept;
  bool extend_or_send_joined(RegisterBus& bus) noexcept;
  void send_joined() noexcept;
  [[nodiscard]] bool joint_move_follows() const noexcept;
  [[nodiscard]] bool joints_have_outputs() const noexcept;
  [[nodiscard]] std::size_t joined_moves() const noexcept;
  void plan_chain(RegisterBus& bus) noexcept;
  void work_on_chain(RegisterBus& bus) noexcept;
  [[nodiscard]] bool extend_chain() noexcept;
  [[nodiscard]] const CartesianMove* next_of_chain() const noexcept;
  void collect_for_window() noexcept;
  [[nodiscard]] bool execute_window(RegisterBus& bus) noexcept;
  [[nodiscard]] bool continue_window(RegisterBus& bus) noexcept;
  [[nodiscard]] double expected_ticks(std::size_t moves) const noexcept;
  void measure_planning(RegisterBus& bus) noexcept;
  [[nodiscard]] bool await_window() noexcept;
  void open_window() noexcept;
  void close_window() noexcept;
  void close_late_window() noexcept;
  [[nodiscard]] bool is_braking() const noexcept;
  void settle_dropped_window(Refusal reason) noexcept;
  void drop_rest_of_chain() noexcept;
  void refuse_chain(const PathProblem& problem) noexcept;
  [[nodiscard]] Transform planned_tool_pose() const noexcept;
  // The conveyor; in a file of its own.
  [[nodiscard]] bool release_part() noexcept;
  [[nodiscard]] bool plan_on_conveyor(const CartesianMove& move, RegisterBus& bus) noexcept;
  [[nodiscard]] bool dwell_on_conveyor(const Dwell& dwell, RegisterBus& bus) noexcept;
  void check_on_conveyor(RegisterBus& bus) noexcept;
  void lose_part(Refusal reason = Refusal::kPartLost) noexcept;

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
  bool gap_ = false;                               // a move was refused after the last accepted one
  Tag clear_tag_{};                                // of the ClearFault that core 0 has not answered yet
  ArmPlane plane_;                                 // with the tool
  Chain chain_;                                    // being planned
  CartesianPlanner planner_;
  JointChain joints_;                                                // being planned, not sent yet
  std::array<PathOutputs, JointChain::kMaxMoves> joints_outputs_{};  // of the moves of joints_
  JointMove last_joint_{};                                           // the last move of joints_
  PerAxis<Radians> joints_start_{};                                  // begin of joints_
  PerAxis<Radians> joints_via_{};                                    // begin of last_joint_
  double joints_blend_rad_ = 0.0;                                    // of the corner at joints_via_ between joint moves
  bool joints_open_ = false;                                         // another move may join
  double path_blend_mm_ = 0.0;                                       // of the last path of joined(), at its end
  bool path_left_ = false;                                           // joints_ begins in motion on that path
  // At most one of both is under way. The move that departs is still the first one of waiting_.
  std::optional<DeparturePlanner> departure_;  // of the joint move `departing_` from that path
  std::optional<ArrivalPlanner> arrival_;      // of last_joint_ on the path of planner_
  JointMove departing_{};
  double departing_residual_rad_ = 0.0;
  Window window_ = Window::kNone;
  std::size_t window_moves_ = 0;
  bool in_time_ = true;          // the first move of chain_, which follows an open window, came before the arm brakes
  bool unasked_stop_ = false;    // before the first move of chain_, which is planned from rest
  bool dropping_chain_ = false;  // a move of a chain in windows was refused, and those behind it are
  PlanningCost planning_cost_;
  Cycles plan_begun_{};                        // when the planning of the last chain began
  std::uint32_t plans_late_ = 0;               // of MotionMailbox::plans_late, those that are known here
  std::uint32_t plans_queued_ = 0;             // number of entries of MotionMailbox::plans that were sent; wraps
  std::uint32_t plans_sent_ = 0;               // number of plans and `retargets`; wraps like MotionMailbox::plans_over
  std::uint32_t retargets_accepted_ = 0;       // joint moves that begin at once; wraps
  std::optional<JointMove> next_retarget_{};   // the latest of them, to be sent
  std::uint32_t retarget_sent_ = 0;            // value of retargets_accepted_ for the one that was sent last
  std::optional<VelocityCommand> next_jog_{};  // to be sent at the end of this execute()
  std::uint32_t jogs_sent_ = 0;                // wraps like MotionNotice::jogs
  std::optional<Refusal> dropping_program_{};  // moves of Source::kProgram that are still in their inbox are dropped
  bool jogging_ = false;                       // in kAwaitingRest: a jog is under way that was not ended
  std::optional<VelocityCommand::Kind> jog_ended_{};  // in kAwaitingRest: what has ended a jog that is under way
  bool referenced_ = true;                            // all joint angles are known, as far as core 1 knows
  bool homing_ = false;                               // in kAwaitingRest: axes are being homed, and this was not ended
  StreamFeed stream_;
  UserFrames frames_;  // the last one is that in which a path on the conveyor is planned
  ConveyorFeed conveyor_;
  bool chain_on_conveyor_ = false;  // chain_ is in the frame of the part
};

// Into its place in the queue: a plan has no room on the stack.
template <class Plan>
void Dispatcher::send_plan(const Plan& plan) noexcept {
  joined() = plan;
  send_entries(1);
}

}  // namespace armature
