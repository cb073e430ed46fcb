// The choice of a branch without computing those that cannot win. A joint move takes as long as its slowest joint, so
// joints 1 to 3 limit from below what any wrist can reach.
//
// Of the four shoulders and elbows the one that takes least comes first. As soon as those left take longer than the
// best branch, none of them can win: mostly one or two of the four wrists are computed.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/joint_lanes.hpp"
#include "controller/kinematics/six_r_parts.hpp"

namespace armature {
namespace {

using math::Lanes;

// Two branches that are placed joint by joint: turns, limits and times.
class Pair {
 public:
  Pair(const ArmGeometry& geometry, const JointAngles& previous, const PerAxis<JointRange>& ranges) noexcept
      : geometry_{geometry}, previous_{previous}, ranges_{ranges} {}

  void place(std::size_t axis, Lanes theta) noexcept {
    const double from_rad = previous_[axis].value();
    const Lanes joint = nearest_turns(geometry_.sign[axis] * (theta - geometry_.offset_rad[axis]), from_rad);
    within_ &= inside(joint, ranges_[axis]);
    times_s_ = larger(times_s_, move_times_s(joint, from_rad, ranges_[axis].max_speed_rad_s));
    joints_[0][axis] = Radians{joint[0]};
    joints_[1][axis] = Radians{joint[1]};
  }

  // The time of the joints first .. end - 1; infinite when one has no turn inside its limits.
  [[nodiscard]] double time_s(std::size_t lane, std::size_t first, std::size_t end) noexcept {
    return within_[lane] != 0 ? times_s_[lane] : turned_time_s(joints_[lane], first, end);
  }
  [[nodiscard]] const JointAngles& joints(std::size_t lane) const noexcept { return joints_[lane]; }

 private:
  double turned_time_s(JointAngles& joints, std::size_t first, std::size_t end) const noexcept {
    double time_s = 0.0;
    for (std::size_t axis = first; axis < end; ++axis) {
      double joint_rad = turned_inside(joints[axis].value(), ranges_[axis]);
      if (limit_excess(joint_rad, ranges_[axis]) != 0.0) return std::numeric_limits<double>::infinity();
      joints[axis] = Radians{joint_rad};
      time_s = std::max(time_s, std::fabs(joint_rad - previous_[axis].value()) / ranges_[axis].max_speed_rad_s);
    }
    return time_s;
  }

  const ArmGeometry& geometry_;
  const JointAngles& previous_;
  const PerAxis<JointRange>& ranges_;
  math::Masks within_ = math::all_lanes(~std::uint64_t{0});
  Lanes times_s_{};
  std::array<JointAngles, 2> joints_;
};

// A shoulder and an elbow.
struct Start {
  std::size_t arm = 0;
  double time_s = 0.0;  // no wrist makes it less
  JointAngles joints{};
};

}  // namespace

IkTracking Arm::soonest_of(const SixR& six_r, const Transform& base_T_flange,
                           const JointAngles& previous) const noexcept {
  const Theta theta = to_theta(previous);
  if (!is_rigid(base_T_flange) || !are_angles(theta)) return {};
  const SixR::Arms arms = six_r.arms(base_T_flange, theta);

  std::array<Start, SixR::Arms::kMax> starts;
  std::size_t count = 0;
  for (std::size_t first = 0; first < arms.count; first += 2) {
    const SixR::Arms::Posed &up = arms.posed[first], &down = arms.posed[first + 1];
    Pair pair{geometry_, previous, ranges_};
    pair.place(0, math::all_lanes(arms.sides[up.side].shoulder.theta1));
    pair.place(1, Lanes{up.theta2, down.theta2});
    pair.place(2, Lanes{up.theta3, down.theta3});
    for (std::size_t lane = 0; lane < 2; ++lane) {
      const double time_s = pair.time_s(lane, 0, 3);
      if (time_s == std::numeric_limits<double>::infinity()) continue;
      std::size_t at = count++;
      for (; at > 0 && time_s < starts[at - 1].time_s; --at) starts[at] = starts[at - 1];
      starts[at] = {first + lane, time_s, pair.joints(lane)};
    }
  }

  IkTracking best;
  double least_time_s = std::numeric_limits<double>::infinity();
  std::size_t best_index = 0;
  for (std::size_t i = 0; i < count && starts[i].time_s <= least_time_s; ++i) {
    std::array<RawBranch, 2> flips;
    const std::size_t found = SixR::add_wrists(arms, starts[i].arm, 1, theta[3], flips);
    const RawBranch &one = flips[0], &other = flips[found - 1];
    Pair wrists{geometry_, previous, ranges_};
    for (std::size_t axis = 3; axis < kAxes; ++axis) wrists.place(axis, Lanes{one.theta[axis], other.theta[axis]});
    for (std::size_t lane = 0; lane < found; ++lane) {
      const double time_s = std::max(starts[i].time_s, wrists.time_s(lane, 3, kAxes));
      if (!(time_s <= least_time_s) || time_s == std::numeric_limits<double>::infinity()) continue;
      JointAngles joints = starts[i].joints;
      std::copy(wrists.joints(lane).begin() + 3, wrists.joints(lane).end(), joints.begin() + 3);
      const std::size_t index = 2 * starts[i].arm + lane;
      if (time_s == least_time_s) {
        const double squares = move_squares_s2(joints, previous, ranges_);
        const double least = move_squares_s2(best.joints, previous, ranges_);
        if (squares > least || (squares == least && index > best_index)) continue;
      }
      least_time_s = time_s;
      best_index = index;
      const RawBranch& branch = lane == 0 ? one : other;
      best = {.joints = joints, .found = true, .status = status_of(branch), .singular = branch.singular};
    }
  }
  return best;
}

IkTracking Arm::soonest(const Transform& base_T_flange, const JointAngles& previous,
                        const Configuration& wanted) const noexcept {
  if (const auto* six_r = std::get_if<SixR>(&family_); six_r != nullptr && requested_parts(wanted) == 0) {
    const IkTracking found = soonest_of(*six_r, base_T_flange, previous);
    if (found.found) return found;
  }
  const IkSolutions all = inverse(base_T_flange, previous, wanted);
  IkTracking one{.found = all.selected >= 0,
                 .status = all.status,
                 .singular = all.singular,
                 .axis = all.axis,
                 .margin_mm = all.margin_mm,
                 .residual_rad = all.residual_rad,
                 .configuration = all.configuration};
  if (one.found) one.joints = all.branches[static_cast<std::size_t>(all.selected)].joints;
  if (!one.found && one.axis != 0) one.joints[one.axis - 1U] = Radians{all.angle_rad};
  return one;
}

}  // namespace armature
