#include "controller/kinematics/branch_choice.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "controller/base/math.hpp"
#include "controller/kinematics/joint_lanes.hpp"
#include "controller/kinematics/raw_solutions.hpp"
#include "controller/kinematics/turns.hpp"

namespace armature {

using math::Lanes;

double turned_inside(double nearest, const JointRange& range) noexcept {
  // Beyond a limit, the nearest candidate is the first turn inside it, unless that is beyond the other limit.
  const auto toward = [](double beyond_rad) {  // beyond by more than the tolerance
    const double turns = (beyond_rad - kLimitTolerance_rad) / kTurn_rad;
    return turns <= 1.0 ? kTurn_rad : -kTurn_rad * whole_turns(-turns);  // rounded up
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

double move_squares_s2(const JointAngles& joints, const JointAngles& previous,
                       const PerAxis<JointRange>& ranges) noexcept {
  double squares_s2 = 0.0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    squares_s2 += math::square(std::fabs((joints[axis] - previous[axis]).value()) / ranges[axis].max_speed_rad_s);
  }
  return squares_s2;
}

void choose_branch(IkSolutions& solutions, const JointAngles& previous, const PerAxis<JointRange>& ranges) noexcept {
  if (solutions.count == 0) return;
  double least_time_s = std::numeric_limits<double>::infinity(), least_excess_rad = least_time_s;
  solutions.selected = -1;
  const auto consider = [&](std::size_t i, double time_s) {
    if (time_s > least_time_s) return;
    if (time_s == least_time_s) {
      const IkBranch& best = solutions.branches[static_cast<std::size_t>(solutions.selected)];
      const auto squares = [&](const IkBranch& branch) { return move_squares_s2(branch.joints, previous, ranges); };
      if (squares(solutions.branches[i]) >= squares(best)) return;
    }
    least_time_s = time_s;
    solutions.selected = static_cast<int>(i);
  };
  for (std::size_t i = 0; i < solutions.count; i += 2) {
    const std::size_t next = std::min(i + 1, solutions.count - 1);
    IkBranch& a = solutions.branches[i];
    IkBranch& b = solutions.branches[next];
    std::array<Lanes, kAxes> joints;
    unsigned outside = 0;  // a bit for each axis
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const Lanes angles{a.joints[axis].value(), b.joints[axis].value()};
      joints[axis] = nearest_turns(angles, previous[axis].value());
      outside |= (math::both(inside(joints[axis], ranges[axis])) ? 0U : 1U) << axis;
    }
    Lanes worst_rad{}, worst_axis{};
    for (; outside != 0; outside &= outside - 1) {
      const auto axis = static_cast<std::size_t>(std::countr_zero(outside));
      const auto [joint, excess] = turn_inside(joints[axis], ranges[axis]);
      joints[axis] = joint;
      worst_axis = math::select(excess > worst_rad, math::all_lanes(static_cast<double>(axis + 1)), worst_axis);
      worst_rad = larger(worst_rad, excess);
    }
    Lanes times_s{};
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      times_s = larger(times_s, move_times_s(joints[axis], previous[axis].value(), ranges[axis].max_speed_rad_s));
      a.joints[axis] = Radians{joints[axis][0]};
      b.joints[axis] = Radians{joints[axis][1]};
    }
    for (std::size_t lane = 0; lane <= next - i; ++lane) {
      IkBranch& branch = solutions.branches[i + lane];
      branch.within_limits = worst_rad[lane] == 0.0;
      branch.outside_axis = static_cast<std::uint8_t>(worst_axis[lane]);
      if (branch.within_limits) {
        consider(i + lane, times_s[lane]);
      } else if (worst_rad[lane] < least_excess_rad) {
        least_excess_rad = worst_rad[lane];
        solutions.axis = branch.outside_axis;
        solutions.angle_rad = branch.joints[branch.outside_axis - 1U].value();
      }
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
  solutions.angle_rad = 0.0;
}

}  // namespace armature
