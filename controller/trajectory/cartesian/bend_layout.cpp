#include "controller/trajectory/cartesian/bend_layout.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "controller/trajectory/cartesian/path_corners.hpp"
#include "controller/trajectory/path/orientation_path.hpp"

namespace armature {
namespace {

constexpr double kFarFromWrist = 0.35;    // farther from the singularity no bend begins
constexpr double kAtWrist_rad = 1e-3;     // a path that begins or ends closer to the singularity has no direction
constexpr double kNarrowest_rad = 4e-3;   // of a bend
constexpr double kLeastRatio = 2.5;       // of the angle at the ends of a bend to that by which the path misses
constexpr double kSpare = 0.98;           // of the tolerance: the samples may miss the largest deviation
constexpr double kDerivativeStep = 1e-3;  // of a bend
constexpr int kRefinements = 6, kBisections = 40, kDeviations = 16;

bool may_bend(const CartesianSegment& segment) {
  return segment.at_singularity == AtSingularity::kBend;
}

// The share of the chord from a to b at which it is closest to the origin, any number.
double closest_share(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d chord = b - a;
  const double square = chord.squaredNorm();
  return square > 0.0 ? -a.dot(chord) / square : 0.5;
}

}  // namespace

bool BendLayout::may_need(const CartesianPlan& plan, double least_wrist) noexcept {
  const auto end = plan.segments.begin() + static_cast<std::ptrdiff_t>(plan.count);
  return least_wrist < (std::any_of(plan.segments.begin(), end, may_bend) ? kFarFromWrist : kNarrowest_rad);
}

double BendLayout::allowed_deviation(const CartesianSegment& segment) noexcept {
  return may_bend(segment) ? std::max(segment.orientation_tolerance_rad, kHair_rad) : kHair_rad;
}

void BendLayout::begin(const CartesianPlan& plan) noexcept {
  segment_ = 0;
  index_ = 0;
  samples_ = 0;
  last_share_ = 0.0;
  inverses_ = 0;
  while (plan.segments[segment_].length == 0.0) ++segment_;
  history_[0].joints = plan.start;
}

std::optional<BendLayout::Sample> BendLayout::sample(const CartesianPlan& plan, double s,
                                                     const JointAngles& near) noexcept {
  ++inverses_;
  const Transform pose = tool_on_path(plan, s).tool.base_T_tool;
  const IkTracking tracking = arm_.track_keeping_elbow(pose * plan.tool_T_flange, near);
  if (!tracking.found || (!solved(tracking.status) && tracking.status != IkStatus::kOutsideLimits)) return std::nullopt;
  return Sample{.s = s, .joints = tracking.joints, .approach = arm_.approach_in_forearm(tracking.joints)};
}

BendLayout::Progress BendLayout::step(CartesianPlan& plan) noexcept {
  inverses_ = 0;
  if (index_ > kSamples) {
    index_ = 1;  // the first sample of a segment is the last one of the segment before
    do {
      if (++segment_ >= plan.count) return Progress::kDone;
    } while (plan.segments[segment_].length == 0.0);
  }
  const CartesianSegment& segment = plan.segments[segment_];
  const double s = segment.from + segment.length * index_++ / kSamples;
  const Sample* last = samples_ > 0 ? &history_[(samples_ - 1) % kHistory] : nullptr;
  if (last != nullptr && s <= last->s) return Progress::kWorking;  // on a bend
  const std::optional<Sample> next = sample(plan, s, last != nullptr ? last->joints : history_[0].joints);
  if (!next) return Progress::kDone;  // the check of the set-points reports it
  if (last != nullptr) consider(plan, *next);
  // A bend may end behind the sample.
  if (samples_ == 0 || history_[(samples_ - 1) % kHistory].s < s) history_[samples_++ % kHistory] = *next;
  return Progress::kWorking;
}

// The interval from the last sample to `next`.
void BendLayout::consider(CartesianPlan& plan, const Sample& next) noexcept {
  const Sample last = history_[(samples_ - 1) % kHistory];
  const double share = closest_share(last.approach, next.approach);
  const double before = std::exchange(last_share_, share);
  const Room room = room_around(plan, 0.5 * (last.s + next.s));
  const bool first = last.s <= room.from, ends = next.s >= room.to;
  // Between two intervals: the chord before leads closer, this one leads away.
  const bool here = share > 0.0 ? share < 1.0 || ends : first || before >= 1.0;
  const double at = std::clamp(share, 0.0, 1.0);
  if (!here || (last.approach + at * (next.approach - last.approach)).norm() > kFarFromWrist) return;

  double closest = last.s + at * (next.s - last.s), miss = 0.0;
  if (!find_closest(plan, room, closest, miss, next.s - last.s)) return;
  if (!(miss < kSpare * room.tolerance_rad)) return;
  const bool at_end = (closest <= room.from && room.rests_before) || (closest >= room.to && room.rests_after);
  if (at_end && miss > kAtWrist_rad) return;  // it only begins or ends near the singularity
  for (double angle = std::max(kWidest_rad, kLeastRatio * miss); angle >= kNarrowest_rad; angle *= 0.5) {
    if (angle < kLeastRatio * miss || plan.bends.count == WristBends::kMax) return;
    Sample behind;
    if (!place(plan, room, closest, angle, behind)) continue;
    samples_ = 0;
    history_[samples_++] = behind;
    last_share_ = 0.0;
    return;
  }
}

BendLayout::Room BendLayout::room_around(const CartesianPlan& plan, double s) const noexcept {
  std::size_t first = segment_on_path(plan, s), last = first;
  Room room{.tolerance_rad = allowed_deviation(plan.segments[first])};
  const auto joins = [&](std::size_t before, std::size_t other) {
    return joint_after(plan, before) != PathJoint::kStop &&
           allowed_deviation(plan.segments[other]) >= room.tolerance_rad;
  };
  while (first > 0 && joins(first - 1, first - 1)) --first;
  while (last + 1 < plan.count && joins(last, last + 1)) ++last;
  room.from = plan.segments[first].from;
  room.to = plan.segments[last].from + plan.segments[last].length;
  room.rests_before = first == 0 || joint_after(plan, first - 1) == PathJoint::kStop;
  room.rests_after = last + 1 == plan.count || joint_after(plan, last) == PathJoint::kStop;
  if (plan.bends.count > 0 && plan.bends.bends[plan.bends.count - 1].to > room.from) {
    room.from = plan.bends.bends[plan.bends.count - 1].to;
    room.rests_before = false;
  }
  return room;
}

bool BendLayout::find_closest(const CartesianPlan& plan, const Room& room, double& s, double& miss,
                              double width) noexcept {
  const JointAngles near = history_[(samples_ - 1) % kHistory].joints;
  for (int i = 0; i < kRefinements; ++i, width *= 0.2) {
    const std::optional<Sample> a = sample(plan, std::max(s - width, room.from), near);
    const std::optional<Sample> b = sample(plan, std::min(s + width, room.to), near);
    if (!a || !b) return false;
    const double share = std::clamp(closest_share(a->approach, b->approach), 0.0, 1.0);
    s = a->s + share * (b->s - a->s);
    miss = (a->approach + share * (b->approach - a->approach)).norm();
  }
  return true;
}

const JointAngles& BendLayout::joints_before(double s) const noexcept {
  std::size_t index = samples_ - 1;
  const std::size_t oldest = samples_ > kHistory ? samples_ - kHistory : 0;
  while (index > oldest && history_[index % kHistory].s > s) --index;
  return history_[index % kHistory].joints;
}

// Where the path between `closest` and `limit` is at `angle` from the singularity, about. Only a limit at which the
// tool rests may be closer.
std::optional<BendLayout::Sample> BendLayout::find_edge(const CartesianPlan& plan, double closest, double limit,
                                                        bool limit_rests, double angle) noexcept {
  const auto at = [&](double s) { return sample(plan, s, joints_before(s)); };
  std::optional<Sample> edge = at(limit);
  if (!edge) return std::nullopt;
  if (edge->approach.norm() <= angle) return limit_rests ? edge : std::nullopt;
  double inside = closest, outside = limit;
  for (int i = 0; i < kBisections; ++i) {
    edge = at(0.5 * (inside + outside));
    if (!edge) return std::nullopt;
    const double found = edge->approach.norm();
    if (std::fabs(found - angle) <= 0.1 * angle) return edge;
    (found < angle ? inside : outside) = edge->s;
  }
  return std::nullopt;
}

bool BendLayout::place(CartesianPlan& plan, const Room& room, double closest, double angle, Sample& last) noexcept {
  const std::optional<Sample> from = find_edge(plan, closest, room.from, room.rests_before, angle);
  std::optional<Sample> to = find_edge(plan, closest, room.to, room.rests_after, angle);
  if (!from || !to || !(from->s < to->s)) return false;
  to = sample(plan, to->s, from->joints);  // the solution that the shortest turn of the wrist leads to
  if (!to) return false;

  WristBend bend{.from = from->s, .to = to->s};
  const double length = bend.to - bend.from;
  BendEnds first = end_of_bend(plan, *from, room, kDerivativeStep * length);
  BendEnds end = end_of_bend(plan, *to, room, kDerivativeStep * length);
  const auto accepted = [&] {
    for (std::size_t i = 0; i < WristBend::kJoints; ++i) {
      bend.coefficients[i] = bend_between(first[i], end[i], length);
    }
    return within_tolerance(plan, bend, from->joints, room.tolerance_rad);
  };
  if (!accepted()) {
    // At a rest the derivatives are free. The path may lead a joint beyond its limits there; the chord does not.
    const bool rests_first = from->s <= room.from, rests_last = to->s >= room.to;
    for (std::size_t i = 0; i < WristBend::kJoints; ++i) {
      const double chord = (end[i].angle - first[i].angle) / length;
      if (rests_first) first[i] = {.angle = first[i].angle, .slope = chord};
      if (rests_last) end[i] = {.angle = end[i].angle, .slope = chord};
    }
    if ((!rests_first && !rests_last) || !accepted()) return false;
  }
  plan.bends.bends[plan.bends.count++] = bend;
  last = *to;
  return true;
}

// At a rest: those of the path inside the bend, or 0 where it has no direction.
BendLayout::BendEnds BendLayout::end_of_bend(const CartesianPlan& plan, const Sample& at, const Room& room,
                                             double step) noexcept {
  BendEnds ends;
  for (std::size_t i = 0; i < ends.size(); ++i) ends[i].angle = at.joints[WristBend::kFirst + i].value();
  const bool first = at.s <= room.from, last = at.s >= room.to;
  if ((first || last) && at.approach.norm() < kAtWrist_rad) return ends;
  // Differences of five points: a jump of a derivative at the end is a jerk.
  const double middle = first ? at.s + 2.0 * step : last ? at.s - 2.0 * step : at.s;
  std::array<Sample, 5> around;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const std::optional<Sample> next = sample(plan, middle + (static_cast<double>(i) - 2.0) * step, at.joints);
    if (!next) return ends;
    around[i] = *next;
  }
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const auto q = [&](std::size_t point) { return around[point].joints[WristBend::kFirst + i].value(); };
    ends[i].bend = (16.0 * (q(1) + q(3)) - (q(0) + q(4)) - 30.0 * q(2)) / (12.0 * step * step);
    ends[i].slope = (8.0 * (q(3) - q(1)) - (q(4) - q(0))) / (12.0 * step) + (at.s - middle) * ends[i].bend;
  }
  return ends;
}

bool BendLayout::within_tolerance(const CartesianPlan& plan, const WristBend& bend, const JointAngles& near,
                                  double tolerance_rad) noexcept {
  const Eigen::Vector3d flange_p_tool_mm = inverse(plan.tool_T_flange).position_mm;
  JointAngles joints = near;
  for (int i = 1; i < kDeviations; ++i) {
    ++inverses_;
    const double s = bend.from + (bend.to - bend.from) * i / kDeviations;
    const Transform wanted = tool_on_path(plan, s).tool.base_T_tool;
    const IkTracking tracking = track_on_bend(bend, arm_, s, wanted.position_mm, flange_p_tool_mm, joints);
    if (!solved(tracking.status)) return false;
    joints = tracking.joints;
    const Transform held = held_tool_pose(plan, arm_, joints);
    if (!(turn(wanted.rotation, held.rotation).angle_rad <= kSpare * tolerance_rad)) return false;
  }
  return true;
}

}  // namespace armature
