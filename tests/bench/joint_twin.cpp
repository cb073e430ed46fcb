#include "tests/bench/joint_twin.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <variant>

#include "controller/activity/plans/stages/path_requests.hpp"
#include "controller/cell/frames.hpp"
#include "controller/trajectory/joint/joint_move.hpp"
#include "controller/trajectory/path/arm_plane.hpp"
#include "controller/trajectory/plan/cartesian_planner.hpp"
#include "cosim/scenario/to_controller.hpp"
#include "tests/controller/support/finish_plan.hpp"

namespace armature::bench {
namespace {

using cosim::CommandSpec;
using cosim::Scenario;

constexpr double kDegPerRad = 180.0 / std::numbers::pi;

class Twin {
 public:
  explicit Twin(const Scenario& scenario)
      : robot_{cosim::to_robot_model(scenario.robot)},
        config_{cosim::to_controller_config(scenario)},
        arm_{robot_},
        plane_{robot_.arm, config_.flange_T_tool},
        planner_{robot_, arm_, config_.flange_T_tool, config_.max_stretch} {}

  CommandSpec joint(const CommandSpec& move) {
    const Command command = cosim::to_command(move);
    if (const auto* pose = std::get_if<PoseMove>(&command)) {
      now_ = nearest(resolve(pose->target, config_.base_T_user, tool(), plane_, false));
    } else {
      now_ = std::get<JointMove>(command).target;
    }
    return to_now(move, std::get<cosim::JointSpec>(move.kind).speed_percent);
  }

  // Lines first .. last - 1 as one chain.
  void chain(Scenario& scenario, std::size_t first, std::size_t last) {
    PathRequests chain;
    chain.restart(tool());
    for (std::size_t i = first; i < last; ++i) {
      chain.add(std::get<CartesianMove>(cosim::to_command(scenario.moves[i])), config_.base_T_user, plane_);
    }
    planner_.begin(now_, chain.requests());
    if (armature::test::finish_plan(planner_) != CartesianPlanner::Progress::kDone)
      throw std::invalid_argument{"a line is refused"};
    const CartesianPlan& plan = planner_.plan();
    for (std::size_t i = 0; i < plan.count; ++i) {
      const Ticks end = i + 1 < plan.count ? plan.segments[i + 1].start : plan.duration;
      const JointAngles from = now_;
      now_ = nearest(chain.requests()[i].target);
      CommandSpec& move = scenario.moves[first + i];
      move = to_now(move, 100.0 * speed_that_takes(end - plan.segments[i].start, from));
    }
  }

 private:
  [[nodiscard]] Transform tool() const { return arm_.forward(now_) * config_.flange_T_tool; }

  [[nodiscard]] JointAngles nearest(const Transform& base_T_tool) const {
    const IkSolutions all = arm_.inverse(base_T_tool * inverse(config_.flange_T_tool), now_);
    if (!solved(all.status)) throw std::invalid_argument{"a pose is out of reach"};
    return all.branches[static_cast<std::size_t>(all.selected)].joints;
  }

  [[nodiscard]] double speed_that_takes(Ticks duration, const JointAngles& from) const {
    double low = 0.001, high = 1.0;
    for (int i = 0; i < 40; ++i) {
      const double speed = 0.5 * (low + high);
      (plan_joint_move(robot_, from, now_, speed, config_.sync).duration > duration ? low : high) = speed;
    }
    return high;
  }

  [[nodiscard]] CommandSpec to_now(const CommandSpec& old, double speed_percent) const {
    CommandSpec move;
    move.at_s = old.at_s;
    move.kind = cosim::JointSpec{
        .target_deg = make_per_axis([this](std::size_t axis) { return kDegPerRad * now_[axis].value(); }),
        .speed_percent = speed_percent};
    return move;
  }

  RobotModel robot_;
  ControllerConfig config_;
  Arm arm_;
  ArmPlane plane_;
  CartesianPlanner planner_;
  JointAngles now_{};
};

}  // namespace

Scenario joint_twin(const Scenario& scenario) {
  Scenario twin = scenario;
  twin.expect = {};
  Twin make{scenario};
  const std::vector<CommandSpec>& moves = scenario.moves;
  for (std::size_t first = 0, last = 0; first < moves.size(); first = last) {
    last = first + 1;
    if (std::holds_alternative<cosim::JointSpec>(moves[first].kind)) {
      twin.moves[first] = make.joint(moves[first]);
    } else if (std::holds_alternative<cosim::LineSpec>(moves[first].kind)) {
      const auto joins = [&] {
        return std::holds_alternative<cosim::LineSpec>(moves[last].kind) && moves[last].at_s == moves[first].at_s &&
               cosim::path_of(moves[last - 1].kind)->blend_mm > 0;
      };
      while (last < moves.size() && joins()) ++last;
      make.chain(twin, first, last);
    } else {
      throw std::invalid_argument{"joint_twin() is of joint moves and lines only"};
    }
  }
  return twin;
}

}  // namespace armature::bench
