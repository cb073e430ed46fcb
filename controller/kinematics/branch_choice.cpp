#include "controller/kinematics/branch_choice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "controller/kinematics/raw_solutions.hpp"
#include "controller/kinematics/turns.hpp"

namespace armature {

namespace {

struct Cost {
  double time_s = std::numeric_limits<double>::infinity();
  double squares_s2 = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool less_than(const Cost& other) const noexcept {
    return time_s != other.time_s ? time_s < other.time_s : squares_s2 < other.squares_s2;
  }
};

// The best move so far, with the steps beyond which another one certainly takes longer: such a branch needs no
// division.
class Best {
 public:
  Best(const JointAngles& previous, const PerAxis<JointRange>& ranges) noexcept : previous_{previous}, ranges_{ranges} {
    longest_rad_.fill(std::numeric_limits<double>::infinity());
  }
  // True when the move to `joints` is better than all before.
  [[nodiscard]] bool improved_by(const JointAngles& joints) noexcept;

 private:
  const JointAngles& previous_;
  const PerAxis<JointRange>& ranges_;
  Cost cost_;
  PerAxis<double> longest_rad_{};
};

Cost cost_of_move(const JointAngles& joints, const JointAngles& previous, const PerAxis<JointRange>& ranges) noexcept {
  Cost cost{0.0, 0.0};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double time_s = std::fabs((joints[axis] - previous[axis]).value()) / ranges[axis].max_speed_rad_s;
    cost.time_s = std::max(cost.time_s, time_s);
    cost.squares_s2 += time_s * time_s;
  }
  return cost;
}

bool Best::improved_by(const JointAngles& joints) noexcept {
  constexpr double kRounding = 1.0 + 1e-12;
  bool longer = false;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    longer |= std::fabs((joints[axis] - previous_[axis]).value()) > longest_rad_[axis];
  }
  if (longer) return false;
  const Cost cost = cost_of_move(joints, previous_, ranges_);
  if (!cost.less_than(cost_)) return false;
  cost_ = cost;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    longest_rad_[axis] = cost.time_s * ranges_[axis].max_speed_rad_s * kRounding;
  }
  return true;
}

// Returns by how much the joint that is farthest outside exceeds its limits.
double place_turns(IkBranch& branch, const JointAngles& previous, const PerAxis<JointRange>& ranges) noexcept {
  double worst_rad = 0.0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    double joint_rad = branch.joints[axis].value();
    const bool nearest = std::fabs(joint_rad - previous[axis].value()) <= 0.5 * kTurn_rad;
    if (nearest && joint_rad >= ranges[axis].min_rad && joint_rad <= ranges[axis].max_rad) continue;  // most of them
    joint_rad = nearest_turn_inside(joint_rad, previous[axis].value(), ranges[axis]);
    const double excess_rad = limit_excess(joint_rad, ranges[axis]);
    branch.joints[axis] = Radians{joint_rad};
    if (excess_rad > worst_rad) {
      worst_rad = excess_rad;
      branch.outside_axis = static_cast<std::uint8_t>(axis + 1);
    }
  }
  branch.within_limits = worst_rad == 0.0;
  return worst_rad;
}

}  // namespace

double limit_excess(double& joint_rad, const JointRange& range) noexcept {
  const double excess_rad = std::max(joint_rad - range.max_rad, range.min_rad - joint_rad);
  if (excess_rad > kLimitTolerance_rad) return excess_rad;
  joint_rad = std::clamp(joint_rad, range.min_rad, range.max_rad);
  return 0.0;
}

double nearest_turn_inside(double joint_rad, double previous_rad, const JointRange& range) noexcept {
  const double nearest = nearest_turn(joint_rad, previous_rad);
  // Beyond a limit, the nearest candidate is the first turn inside it, unless that is beyond the other limit.
  const auto toward = [&](double beyond_rad) {
    return -kTurn_rad * whole_turns(-(beyond_rad - kLimitTolerance_rad) / kTurn_rad);  // rounded up
  };
  double inside = nearest;
  if (nearest > range.max_rad + kLimitTolerance_rad) inside = nearest - toward(nearest - range.max_rad);
  if (nearest < range.min_rad - kLimitTolerance_rad) inside = nearest + toward(range.min_rad - nearest);
  if (inside == nearest) return nearest;

  double ignored = inside;
  if (limit_excess(ignored, range) == 0.0) return inside;
  const double outside = inside + (nearest > inside ? kTurn_rad : -kTurn_rad);
  double ignored_too = outside;
  return limit_excess(ignored, range) <= limit_excess(ignored_too, range) ? inside : outside;
}

void choose_branch(IkSolutions& solutions, const JointAngles& previous, const PerAxis<JointRange>& ranges) noexcept {
  if (solutions.count == 0) return;
  Best best{previous, ranges};
  double least_excess_rad = std::numeric_limits<double>::infinity();
  solutions.selected = -1;
  for (std::size_t i = 0; i < solutions.count; ++i) {
    IkBranch& branch = solutions.branches[i];
    const double excess_rad = place_turns(branch, previous, ranges);
    if (branch.within_limits) {
      if (best.improved_by(branch.joints)) solutions.selected = static_cast<int>(i);
    } else if (excess_rad < least_excess_rad) {
      least_excess_rad = excess_rad;
      solutions.axis = branch.outside_axis;
    }
  }
  if (solutions.selected < 0) {
    solutions.status = IkStatus::kOutsideLimits;
    return;
  }
  const IkBranch& selected = solutions.branches[static_cast<std::size_t>(solutions.selected)];
  solutions.status = status_of(selected.singular, selected.clamped);
  solutions.singular = selected.singular;
  solutions.axis = 0;
}

}  // namespace armature
