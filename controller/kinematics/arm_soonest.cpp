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

constexpr double kNever_s = std::numeric_limits<double>::infinity();

// Where the moves begin that are compared.
struct Origin {
  const ArmGeometry& geometry;
  const PerAxis<JointRange>& ranges;
  const JointAngles& joints;
};

// Two branches that are placed joint by joint: turns, limits and times.
class Pair {
 public:
  explicit Pair(const Origin& origin) noexcept : origin_{origin} {}

  void place(std::size_t axis, Lanes theta) noexcept {
    const ArmGeometry& geometry = origin_.geometry;
    const JointRange& range = origin_.ranges[axis];
    const double from_rad = origin_.joints[axis].value();
    const Lanes joint = nearest_turns(geometry.sign[axis] * (theta - geometry.offset_rad[axis]), from_rad);
    within_ &= inside(joint, range);
    times_s_ = larger(times_s_, move_times_s(joint, from_rad, range.max_speed_rad_s));
    joints_[0][axis] = Radians{joint[0]};
    joints_[1][axis] = Radians{joint[1]};
  }

  // The time of the joints first .. end - 1; kNever_s when one has no turn inside its limits.
  [[nodiscard]] double time_s(std::size_t lane, std::size_t first, std::size_t end) noexcept {
    return within_[lane] != 0 ? times_s_[lane] : turned_time_s(joints_[lane], first, end);
  }
  [[nodiscard]] const JointAngles& joints(std::size_t lane) const noexcept { return joints_[lane]; }

 private:
  double turned_time_s(JointAngles& joints, std::size_t first, std::size_t end) const noexcept {
    double time_s = 0.0;
    for (std::size_t axis = first; axis < end; ++axis) {
      const JointRange& range = origin_.ranges[axis];
      double joint_rad = turned_inside(joints[axis].value(), range);
      if (limit_excess(joint_rad, range) != 0.0) return kNever_s;
      joints[axis] = Radians{joint_rad};
      time_s = std::max(time_s, std::fabs(joint_rad - origin_.joints[axis].value()) / range.max_speed_rad_s);
    }
    return time_s;
  }

  const Origin& origin_;
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

// Those that reach, the one that takes least first.
class Starts {
 public:
  void add(const Start& start) noexcept {
    std::size_t at = count_++;
    for (; at > 0 && start.time_s < sorted_[at - 1].time_s; --at) sorted_[at] = sorted_[at - 1];
    sorted_[at] = start;
  }
  [[nodiscard]] const Start* begin() const noexcept { return sorted_.data(); }
  [[nodiscard]] const Start* end() const noexcept { return sorted_.data() + count_; }

 private:
  std::array<Start, SixR::Arms::kMax> sorted_;
  std::size_t count_ = 0;
};

Starts starts_of(const SixR::Arms& arms, const Origin& origin) noexcept {
  Starts starts;
  for (std::size_t first = 0; first < arms.count; first += 2) {
    const SixR::Arms::Posed &up = arms.posed[first], &down = arms.posed[first + 1];
    Pair pair{origin};
    pair.place(0, math::all_lanes(arms.sides[up.side].shoulder.theta1));
    pair.place(1, Lanes{up.theta2, down.theta2});
    pair.place(2, Lanes{up.theta3, down.theta3});
    for (std::size_t lane = 0; lane < 2; ++lane) {
      const double time_s = pair.time_s(lane, 0, 3);
      if (time_s != kNever_s) starts.add({first + lane, time_s, pair.joints(lane)});
    }
  }
  return starts;
}

// The best of the branches so far: the one that takes least; of those the one with the least squares; of those the
// first.
class Best {
 public:
  explicit Best(const Origin& origin) noexcept : origin_{origin} {}

  [[nodiscard]] double time_s() const noexcept { return time_s_; }
  [[nodiscard]] const IkTracking& branch() const noexcept { return branch_; }

  // A start with a wrist, which is placed in a lane.
  void offer(const Start& start, Pair& wrists, std::size_t lane, const RawBranch& branch) noexcept {
    const double time_s = std::max(start.time_s, wrists.time_s(lane, 3, kAxes));
    if (!(time_s <= time_s_) || time_s == kNever_s) return;
    JointAngles joints = start.joints;
    std::copy(wrists.joints(lane).begin() + 3, wrists.joints(lane).end(), joints.begin() + 3);
    const std::size_t index = 2 * start.arm + lane;
    if (time_s == time_s_ && comes_behind(joints, index)) return;
    time_s_ = time_s;
    index_ = index;
    branch_ = {.joints = joints, .found = true, .status = status_of(branch), .singular = branch.singular};
  }

 private:
  // Of a branch that takes as long as the best one.
  [[nodiscard]] bool comes_behind(const JointAngles& joints, std::size_t index) const noexcept {
    const double squares = move_squares_s2(joints, origin_.joints, origin_.ranges);
    const double least = move_squares_s2(branch_.joints, origin_.joints, origin_.ranges);
    return squares > least || (squares == least && index > index_);
  }

  const Origin& origin_;
  IkTracking branch_;
  double time_s_ = kNever_s;
  std::size_t index_ = 0;
};

}  // namespace

IkTracking Arm::soonest_of(const SixR& six_r, const Transform& base_T_flange,
                           const JointAngles& previous) const noexcept {
  const Theta theta = to_theta(previous);
  if (!is_rigid(base_T_flange) || !are_angles(theta)) return {};
  const SixR::Arms arms = six_r.arms(base_T_flange, theta);
  const Origin origin{geometry_, ranges_, previous};
  Best best{origin};
  for (const Start& start : starts_of(arms, origin)) {
    if (!(start.time_s <= best.time_s())) break;
    std::array<RawBranch, 2> flips;
    const std::size_t found = SixR::add_wrists(arms, start.arm, 1, theta[3], flips);
    const RawBranch &one = flips[0], &other = flips[found - 1];
    Pair wrists{origin};
    for (std::size_t axis = 3; axis < kAxes; ++axis) wrists.place(axis, Lanes{one.theta[axis], other.theta[axis]});
    for (std::size_t lane = 0; lane < found; ++lane) best.offer(start, wrists, lane, flips[lane]);
  }
  return best.branch();
}

IkTracking Arm::soonest(const Transform& base_T_flange, const JointAngles& previous,
                        const Configuration& wanted) const noexcept {
  const auto* six_r = std::get_if<SixR>(&family_);
  if (six_r != nullptr && solver_ == nullptr && requested_parts(wanted) == 0) {
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
