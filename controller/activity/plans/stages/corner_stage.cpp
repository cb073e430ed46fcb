#include "controller/activity/plans/stages/corner_stage.hpp"

#include <variant>

#include "controller/activity/plans/move_events.hpp"
#include "controller/trajectory/plan/path_joint_corner.hpp"

namespace armature {

void CornerStage::work(RegisterBus& bus) noexcept {
  const auto step = [&bus](auto& planner) {
    planner.step();
    const CornerWork& work = planner.work();
    if (work.inverses > 0) bus.charge(Work::kInverse, work.inverses);
    if (work.retargets > 0) bus.charge(Work::kRetarget, work.retargets);
  };
  // The result is used after the commands that came meanwhile have been accepted.
  if (departure_ && departure_->done()) {
    end_departure();
  } else if (departure_) {
    step(*departure_);
  } else if (arrival_->done()) {
    end_arrival();
  } else {
    step(*arrival_);
  }
}

std::size_t CornerStage::moves() const noexcept {
  return moves_in(outbox_.unsent()) + joints_.count() + path_.requests().requests().size();
}

bool CornerStage::joint_move_follows() const noexcept {
  const auto* joint = context_.queue.next_if<JointMove>();
  const auto* pose = context_.queue.next_if<PoseMove>();
  const bool joins = joint != nullptr ? joint->outputs.count == 0 : pose != nullptr && pose->outputs.count == 0;
  return joins && moves() < Plan::kMaxMoves;
}

bool CornerStage::can_join_path() const noexcept {
  const CartesianPlan& plan = path_.planner().plan();
  const bool is_whole = plan.count == path_.requests().requests().size() && moves() <= Plan::kMaxMoves;
  if (!is_whole || !plan.outputs.view().empty()) return false;
  const bool leads_on = path_.requests().last_blend_mm() > 0.0;
  if (leads_on && context_.queue.empty()) return false;  // a window may continue it with a move that is not there yet
  return !joints_.empty() || (leads_on && joint_move_follows());
}

void CornerStage::join_path() noexcept {
  if (joints_.empty()) {
    add_path(Ticks{});
  } else {
    begin_arrival();
  }
}

void CornerStage::add(const JointMove& move, RegisterBus& bus, double residual_rad) noexcept {
  if (joints_.empty() && joining()) return begin_departure(move, residual_rad);
  if (joints_.empty()) path_left_ = false;
  if (joints_.plan(move, bus)) {
    end_adding(move, residual_rad);
  } else {
    refuse_front(Refusal::kInvalidTarget);  // it takes too long
  }
}

void CornerStage::end_adding(const JointMove& move, double residual_rad) noexcept {
  joints_.add(move, residual_rad, move.blend.wanted() && moves() < Plan::kMaxMoves);
  context_.queue.drop_front();
}

void CornerStage::refuse_front(Refusal why) noexcept {
  close();
  context_.queue.refuse_front(why);
}

void CornerStage::close() noexcept {
  joints_.close();
  path_blend_mm_ = 0.0;
}

// From the last path of the joined plan to the front of the queue.
void CornerStage::begin_departure(const JointMove& move, double residual_rad) noexcept {
  const Piece& path = outbox_.unsent().last();
  departing_ = move;
  departing_residual_rad_ = residual_rad;
  departure_.emplace(
      context_.robot, context_.arm, PathBefore{path.path, path.from, path_blend_mm_},
      JointRequest{.target = move.target, .speed = move.speed, .accel = move.accel, .kind = move.profile});
}

void CornerStage::end_departure() noexcept {
  const Departure departure = departure_->departure();
  departure_.reset();
  if (departure.plan.duration > kLongestMove) return refuse_front(Refusal::kInvalidTarget);
  joints_.begin(departure);
  Ticks& until = outbox_.unsent().last().until;
  path_left_ = departure.at < until;
  until = departure.at;
  end_adding(departing_, departing_residual_rad_);
}

// Lets the joint moves end in motion on the path of the planner.
void CornerStage::begin_arrival() noexcept {
  const CartesianPlan& path = path_.planner().plan();
  const JointMove& last = joints_.last();
  ArrivalRequest request{.speed = last.speed,
                         .accel = last.accel,
                         .blend_rad = last.blend.rad,
                         .blend_share = last.blend.share,
                         .half_way_rad = 0.5 * largest_difference(joints_.start_of_last(), path.start),
                         .blend_before_rad = joints_.blend_before_last_rad()};
  if (joints_.count() == 1 && path_left_) {
    const Piece& before = outbox_.unsent().last();
    request.before = PathBefore{before.path, before.from, path_blend_mm_};
    request.exit_at = before.until;
  }
  arrival_.emplace(context_.robot, context_.arm, joints_.chain(), path, request);
}

void CornerStage::end_arrival() noexcept {
  if (joints_.count() == 1 && path_left_) {
    Piece& before = outbox_.unsent().last();
    before.until = arrival_->exit_at();
    path_left_ = before.until < before.path->duration;
  }
  const Ticks from = arrival_->at();
  arrival_.reset();
  outbox_.join(joints_.chain(), Ticks{}, path_left_);
  joints_.clear();
  add_path(from);
}

void CornerStage::add_path(Ticks from) noexcept {
  outbox_.join(path_.planner().plan(), from, from > Ticks{});
  path_blend_mm_ = path_.requests().last_blend_mm();
  path_.planner().cancel();
  path_.clear();
}

void CornerStage::send_joints() noexcept {
  if (!joining()) return joints_.send();
  outbox_.join(joints_.chain(), Ticks{}, path_left_);
  outbox_.send_unsent();
  joints_.clear();
}

void CornerStage::drop(Refusal why) noexcept {
  departure_.reset();
  arrival_.reset();
  Plan& joined = outbox_.unsent();
  for (std::size_t move = 0; move < moves_in(joined); ++move) context_.events.on_event(dropped(joined, move, why));
  joined = {};
}

}  // namespace armature
