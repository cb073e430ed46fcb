// The part of the dispatcher that joins moves of joints, and joint moves and paths.
#include <algorithm>
#include <optional>
#include <variant>

#include "controller/command/dispatcher.hpp"
#include "controller/trajectory/plan/joint_move.hpp"
#include "controller/trajectory/plan/output_places.hpp"
#include "controller/trajectory/plan/path_joint_corner.hpp"

namespace armature {

bool Dispatcher::extend_or_send_joints(RegisterBus& bus) noexcept {
  const WaitingMove* waiting = waiting_.front();
  if (joints_open_ && waiting != nullptr && waiting->follows) {
    const auto joins = [this](const auto* move) {
      return move != nullptr && joints_.count < JointChain::kMaxMoves &&
             (joined().parts() == 0 || move->outputs.count == 0);
    };
    const auto* joint = std::get_if<JointMove>(&waiting->move);
    if (joins(joint)) return plan(*joint, bus), true;
    const auto* pose = std::get_if<PoseMove>(&waiting->move);
    if (joins(pose)) return plan(*pose, bus), true;
    const auto* path = std::get_if<CartesianMove>(&waiting->move);
    const bool leads_on =
        path != nullptr && path->target.frame != kConveyorFrame && path->outputs.count == 0 && !joints_have_outputs();
    if (leads_on && joined().parts() + 1 < MotionPlan::kMaxParts) return plan(*path, bus), true;
  }
  if (!mailbox_.plans.has_room(joined().parts() + 1 == MotionPlan::kMaxParts ? 2 : 1)) return false;
  send_joints();
  return true;
}

void Dispatcher::send_joints() noexcept {
  if (joined().parts() > 0) {
    join(joints_, Ticks{}, path_left_);
    send_joined();
  } else if (joints_.count == 1) {
    JointPlan only = only_joint_move();
    place_outputs(only, joints_outputs_[0]) ? send_plan(only) : refuse_joints(0);
  } else {
    const std::optional<std::size_t> outside = place_outputs(joints_, joints_outputs_);
    outside ? refuse_joints(*outside) : send_plan(joints_);
  }
  joints_.count = 0;
}

// Without a corner it is an ordinary move.
JointPlan Dispatcher::only_joint_move() const noexcept {
  const RetargetPlan& only = joints_.moves[0];
  JointPlan plan = plan_joint_move(robot_, joints_start_, only.target, last_joint_.speed, config_.sync,
                                   last_joint_.profile, last_joint_.accel);
  plan.tag = only.tag;
  plan.residual_rad = only.residual_rad;
  return plan;
}

void Dispatcher::add_to_joints(const JointMove& move, RegisterBus& bus, double residual_rad) noexcept {
  if (joints_.count == 0 && joined().parts() > 0) return begin_departure(move, residual_rad);
  const JointRequest request{.target = move.target, .speed = move.speed, .accel = move.accel, .kind = move.profile};
  int plans = 1;
  if (joints_.count == 0) {
    joints_start_ = planned_end_;
    path_left_ = false;
    const auto rest = [&](std::size_t axis) { return AxisState{.position = planned_end_[axis].value()}; };
    joints_ = plan_retarget(robot_, make_per_axis(rest), request.target, request.speed, request.kind, request.accel);
    if (joints_.duration > kLongestMove) {
      joints_.count = 0;
      plans = 0;
    }
  } else {
    const double ways_rad =
        std::min(largest_difference(joints_via_, planned_end_), largest_difference(planned_end_, move.target));
    joints_blend_rad_ = std::max(last_joint_.blend.rad, 0.5 * last_joint_.blend.share * ways_rad);
    plans = append(joints_, robot_, request, joints_blend_rad_);
  }
  bus.charge(Work::kPlan, std::max(plans, 1));
  plans > 0 ? end_adding(move, residual_rad) : refuse_joint_move(move.tag);
}

// The first waiting move is now the last one of joints_.
void Dispatcher::end_adding(const JointMove& move, double residual_rad) noexcept {
  joints_outputs_[joints_.count - 1] = move.outputs;
  joints_.moves[joints_.count - 1].tag = move.tag;
  joints_.moves[joints_.count - 1].residual_rad = residual_rad;
  joints_via_ = planned_end_;
  planned_end_ = move.target;
  last_joint_ = move;
  joints_open_ = move.blend.wanted() && joined_moves() < MotionPlan::kMaxMoves;
  waiting_.drop_front();
}

// The first waiting move takes too long.
void Dispatcher::refuse_joint_move(Tag tag) noexcept {
  joints_open_ = false;
  path_blend_mm_ = 0.0;
  refuse(Refusal::kInvalidTarget, tag);
  waiting_.drop_front();
}

// The result is used after the commands that came meanwhile have been accepted.
void Dispatcher::work_on_corner(RegisterBus& bus) noexcept {
  const auto step = [&bus](auto& planner) {
    planner.step();
    const CornerWork& work = planner.work();
    if (work.inverses > 0) bus.charge(Work::kInverse, work.inverses);
    if (work.retargets > 0) bus.charge(Work::kRetarget, work.retargets);
  };
  if (departure_) {
    departure_->done() ? end_departure() : step(*departure_);
  } else {
    arrival_->done() ? end_arrival() : step(*arrival_);
  }
}

// From the last path of joined() to the first waiting move.
void Dispatcher::begin_departure(const JointMove& move, double residual_rad) noexcept {
  const MotionPlan::Part path = joined().part(joined().parts() - 1);
  departing_ = move;
  departing_residual_rad_ = residual_rad;
  departure_.emplace(
      robot_, arm_, PathBefore{path.path, path.from, path_blend_mm_},
      JointRequest{.target = move.target, .speed = move.speed, .accel = move.accel, .kind = move.profile});
}

void Dispatcher::end_departure() noexcept {
  const Departure departure = departure_->departure();
  departure_.reset();
  if (departure.plan.duration > kLongestMove) return refuse_joint_move(departing_.tag);
  joints_start_ = planned_end_;
  joints_ = departure.plan;
  joints_.passed = departure.passed;
  path_left_ = departure.at < joined().part(joined().parts() - 1).until;
  joined().cut_last(departure.at);
  end_adding(departing_, departing_residual_rad_);
}

// Until a plan of the planner can be sent together with what comes before it: as two plans, or as one of three parts.
bool Dispatcher::has_room_for_chain() const noexcept {
  using Progress = CartesianPlanner::Progress;
  if (planner_.progress() == Progress::kIdle) return !mailbox_.plans.full();
  return planner_.progress() != Progress::kDone || mailbox_.plans.has_room(joints_.count > 0 ? 2 : 1);
}

// True when the path of the planner, which is done, becomes a part of a joined plan.
bool Dispatcher::can_join_path() const noexcept {
  const CartesianPlan& path = planner_.plan();
  const bool is_whole = path.count == chain_.requests().size() && joined_moves() <= MotionPlan::kMaxMoves;
  if (!is_whole || !path.outputs.view().empty()) return false;
  const bool leads_on = chain_.last_blend_mm() > 0.0;
  if (leads_on && waiting_.empty()) return false;  // a window may continue it with a move that is not there yet
  return joints_.count > 0 || (leads_on && joint_move_follows());
}

template <class Plan>
void Dispatcher::join(const Plan& plan, Ticks from, bool in_motion) noexcept {
  if (joined().parts() + 1 < MotionPlan::kMaxParts) return joined().add(plan, from, in_motion);
  MotionPlan& next = mailbox_.plans.free_slot(1);
  next = plan;
  joined().add_next_of_queue(next, from, in_motion);
}

void Dispatcher::join_path() noexcept {
  joints_.count > 0 ? begin_arrival() : add_path(Ticks{});
}

// Lets the joint moves end in motion on the path of the planner.
void Dispatcher::begin_arrival() noexcept {
  const CartesianPlan& path = planner_.plan();
  ArrivalRequest request{.speed = last_joint_.speed,
                         .accel = last_joint_.accel,
                         .blend_rad = last_joint_.blend.rad,
                         .blend_share = last_joint_.blend.share,
                         .half_way_rad = 0.5 * largest_difference(joints_via_, path.start),
                         .blend_before_rad = joints_blend_rad_};
  if (joints_.count == 1 && path_left_) {
    const MotionPlan::Part before = joined().part(joined().parts() - 1);
    request.before = PathBefore{before.path, before.from, path_blend_mm_};
    request.exit_at = before.until;
  }
  arrival_.emplace(robot_, arm_, joints_, path, request);
}

void Dispatcher::end_arrival() noexcept {
  if (joints_.count == 1 && path_left_) {
    joined().cut_last(arrival_->exit_at());
    path_left_ = arrival_->exit_at() < joined().part(joined().parts() - 1).path->duration;
  }
  const Ticks from = arrival_->at();
  arrival_.reset();
  join(joints_, Ticks{}, path_left_);
  joints_.count = 0;
  add_path(from);
}

void Dispatcher::add_path(Ticks from) noexcept {
  join(planner_.plan(), from, from > Ticks{});
  path_blend_mm_ = chain_.last_blend_mm();
  planner_.cancel();
  chain_.clear();
}

bool Dispatcher::extend_or_send_joined(RegisterBus& bus) noexcept {
  if (path_blend_mm_ > 0.0 && joined().parts() < MotionPlan::kMaxParts && joint_move_follows()) {
    const auto& waiting = waiting_.front()->move;
    if (const auto* joint = std::get_if<JointMove>(&waiting)) {
      plan(*joint, bus);
    } else {
      plan(std::get<PoseMove>(waiting), bus);
    }
    return true;
  }
  if (mailbox_.plans.full()) return false;
  send_joined();
  return true;
}

void Dispatcher::send_joined() noexcept {
  if (joined().parts() == 1) joined().become_path();
  send_entries(joined().entries());
}

bool Dispatcher::joint_move_follows() const noexcept {
  const WaitingMove* waiting = waiting_.front();
  if (waiting == nullptr || !waiting->follows) return false;
  const auto* joint = std::get_if<JointMove>(&waiting->move);
  const auto* pose = std::get_if<PoseMove>(&waiting->move);
  const bool joins = joint != nullptr ? joint->outputs.count == 0 : pose != nullptr && pose->outputs.count == 0;
  return joins && joined_moves() < MotionPlan::kMaxMoves;
}

bool Dispatcher::joints_have_outputs() const noexcept {
  return std::any_of(joints_outputs_.begin(), joints_outputs_.begin() + static_cast<std::ptrdiff_t>(joints_.count),
                     [](const PathOutputs& outputs) { return outputs.count > 0; });
}

// An output of move `to_blame` is outside of the chain.
void Dispatcher::refuse_joints(std::size_t to_blame) noexcept {
  for (std::size_t i = 0; i < joints_.count; ++i) {
    refuse(i == to_blame ? Refusal::kOutputOutside : Refusal::kChainRefused, joints_.moves[i].tag);
  }
  planned_end_ = joints_start_;
}

// Moves that are not sent yet and are, or may be, in one joined plan.
std::size_t Dispatcher::joined_moves() const noexcept {
  return moves_in(joined()) + joints_.count + chain_.requests().size();
}

}  // namespace armature
