#include "controller/trajectory/grid/law_grid.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>

#include "controller/base/math.hpp"
#include "controller/base/rounding.hpp"
#include "controller/base/timebase.hpp"
#include "controller/kinematics/turns.hpp"
#include "controller/robot/axis_units.hpp"
#include "controller/trajectory/cartesian/path_corners.hpp"
#include "controller/trajectory/check/path_check.hpp"
#include "controller/trajectory/grid/tool_limits.hpp"

namespace armature {
namespace {

// Of a piece; the joints are looked at more often.
constexpr std::size_t kMaxFirstPoints = 60;   // of a segment and its corner
constexpr std::size_t kPointsOfFirst = 2048;  // of a law of up to kMaxFirstSegments segments
constexpr std::size_t kMoreOfFirst = kPointsOfFirst / 4;
static_assert(kMaxFirstPoints * CartesianPlan::kMaxFirstSegments + kMoreOfFirst <= kPointsOfFirst);
static_assert(kPointsOfFirst <= SpeedLaw::kMaxPoints);
constexpr int kLineIntervals = 1, kBentIntervals = 16, kJointIntervals = 8;
constexpr int kToolIntervals = 3;           // for the tool alone, for each one for the joints
constexpr std::size_t kPieceIntervals = 4;  // of a spline, between two of its points
constexpr double kNoLength = 1e-9;          // of a piece, as a share of its segment
// The first intervals of windows are about this long, and at most so many.
constexpr double kWindowInterval_mm = 0.5;
constexpr int kWindowIntervals = 4, kWindowCornerIntervals = 2;
constexpr int kStepsAlongPiece = 8;

}  // namespace

LawGrid::LawGrid(const RobotModel& robot, const Arm& arm) noexcept : robot_{robot}, arm_{arm} {
  constexpr double kShare = kJointShare * PathCheck::kCheckedShare;
  for (std::size_t axis = 0; axis < robot.axis_count; ++axis) {
    speed_rad_s_[axis] = kShare * AxisUnits{robot.axes[axis]}.max_speed_rad_s();
    accel_rad_s2_[axis] = kShare * robot.axes[axis].max_accel_rad_s2;
    jerk_rad_s3_[axis] = kShare * robot.axes[axis].max_jerk_rad_s3;
  }
}

void LawGrid::begin(const CartesianPlan& plan, SpeedLaw& law, With with) noexcept {
  const auto has_s_curve = [](const CartesianSegment& segment) { return segment.profile == ProfileKind::kSCurve; };
  const auto segments = std::span{plan.segments}.first(plan.count);
  // The moving average of a law has twice as many points.
  law.clear(std::any_of(segments.begin(), segments.end(), has_s_curve) ? kPointsOfFirst / 2 - 8 : kPointsOfFirst);
  with_ = with;
  inverses_ = 0;
  least_wrist_ = 1.0;
  piece_ = {};
  last_ = {};
  last_.joints = plan.start;
  while (plan.segments[piece_.segment].length == 0.0) ++piece_.segment;
  begin_piece(plan, law);
}

LawGrid::Progress LawGrid::step(const CartesianPlan& plan, SpeedLaw& law) noexcept {
  inverses_ = 0;
  if (ahead_count_ == 0) {
    if (left_ == 0) {
      if (!next_piece(plan)) return Progress::kDone;
      begin_piece(plan, law);
      return Progress::kWorking;
    }
    --left_;
    const double share = static_cast<double>(intervals_ - left_) / intervals_;
    const double s = left_ == 0 ? piece_.to : piece_.from + share * (piece_.to - piece_.from);
    ahead_[ahead_count_++] = point_at(plan, s, last_.joints);
  }
  const Point& end = ahead_[ahead_count_ - 1];
  const double middle_s = 0.5 * (last_.s + end.s);
  if (with_ == With::kJoints && middle_s > last_.s && middle_s < end.s) {
    Point middle = point_at(plan, middle_s, last_.joints);
    if (!fine(last_, middle, end) && has_room(plan, law) && ahead_count_ < kDepth) {
      ahead_[ahead_count_++] = middle;
      return Progress::kWorking;
    }
    if (piece_.part != Part::kBetween) keep_speed_between(law, middle, ahead_[ahead_count_ - 1]);
    append(law, middle, false);
  }
  const bool segment_ends = ahead_count_ == 1 && left_ == 0 && piece_.part == Part::kBetween && !piece_.open_after;
  const bool stops =
      segment_ends && (piece_.segment + 1 == plan.count || joint_after(plan, piece_.segment) == PathJoint::kStop);
  append(law, end, stops);
  --ahead_count_;
  return Progress::kWorking;
}

// Room is left for the first intervals of the pieces behind.
bool LawGrid::has_room(const CartesianPlan& plan, const SpeedLaw& law) const noexcept {
  const std::size_t spare = plan.continues ? kSparePoints : 0;
  return law.size() + ahead_count_ + first_points(plan, piece_.segment) + spare < law.most();
}

std::size_t LawGrid::first_points(const CartesianPlan& plan, std::size_t first) noexcept {
  const int least = plan.continues ? kWindowIntervals : kJointIntervals;
  std::size_t points = 0;
  for (std::size_t i = first; i < plan.count; ++i) {
    points += (plan.continues ? kWindowPoints : kMaxFirstPoints) +
              2 * static_cast<std::size_t>(joint_intervals(plan, i) - least);
  }
  return points;
}

void LawGrid::extend(const CartesianPlan& plan, SpeedLaw& law, std::size_t last, double keep_s) noexcept {
  const CartesianSegment& segment = plan.segments[last];
  with_ = With::kJoints;
  inverses_ = 0;
  ahead_count_ = 0;
  const double start_s = piece_.from;
  piece_.segment = last;
  piece_.part = Part::kBetween;
  piece_.to = segment.from + segment.length - segment.corner;
  piece_.open_before = true;
  piece_.open_after = segment.corner > 0.0;
  law.use(SpeedLaw::kMaxPoints);
  law.drop_behind(std::min(keep_s, piece_.to));
  const double s = law.s(law.size() - 1);
  JointAngles joints = piece_joints_;
  for (int step = 1; step <= kStepsAlongPiece && s > start_s; ++step) {
    joints = joints_at(plan, start_s + (s - start_s) * step / kStepsAlongPiece, joints);
  }
  run_length_ = run_around(plan, last);
  last_ = point_at(plan, s, joints);
  intervals_ = left_ = piece_.to > s ? 1 : 0;
  piece_joints_ = last_.joints;
  piece_.from = s;
}

bool LawGrid::next_piece(const CartesianPlan& plan) noexcept {
  if (piece_.part == Part::kFirstHalf ||
      (piece_.part == Part::kBetween && plan.segments[piece_.segment].corner > 0.0)) {
    piece_.part = piece_.part == Part::kBetween ? Part::kFirstHalf : Part::kSecondHalf;
    return true;
  }
  piece_.part = Part::kBetween;
  do {
    if (++piece_.segment >= plan.count) return false;
  } while (plan.segments[piece_.segment].length == 0.0);
  return true;
}

void LawGrid::begin_piece(const CartesianPlan& plan, SpeedLaw& law) noexcept {
  const CartesianSegment& segment = plan.segments[piece_.segment];
  const double c_before = piece_.segment > 0 ? plan.segments[piece_.segment - 1].corner : 0.0;
  const double end = segment.from + segment.length;
  if (piece_.part != Part::kBetween) {
    piece_.from = piece_.part == Part::kFirstHalf ? end - segment.corner : end;
    piece_.to = piece_.part == Part::kFirstHalf ? end : end + segment.corner;
    piece_.open_before = piece_.open_after = true;
  } else {
    piece_.from = segment.from + c_before;
    piece_.to = end - segment.corner;
    if (piece_.to - piece_.from < kNoLength * segment.length) piece_.to = piece_.from;  // rounding between two corners
    piece_.open_before = c_before > 0.0;
    piece_.open_after = segment.corner > 0.0;
  }
  const bool run_begins = piece_.part == Part::kBetween &&
                          (piece_.segment == 0 || joint_after(plan, piece_.segment - 1) == PathJoint::kStop);
  if (run_begins || law.size() == 0) run_length_ = run_around(plan, piece_.segment);
  intervals_ = left_ = first_intervals(plan);
  const bool smooth = piece_.part == Part::kBetween && c_before == 0.0 && piece_.segment > 0 && law.size() > 0 &&
                      joint_after(plan, piece_.segment - 1) == PathJoint::kSmooth;
  Point first = point_at(plan, piece_.from, last_.joints);
  piece_joints_ = first.joints;
  if (smooth) {
    pass_smoothly(plan, last_, first);
    law.limits(law.size() - 1) = last_.limits;
  }
  append(law, first, false);
  if (!(piece_.to > piece_.from)) left_ = 0;
}

// A path of several turns or pieces is looked at as often on each of them, as far as the room for points permits.
int LawGrid::joint_intervals(const CartesianPlan& plan, std::size_t segment) noexcept {
  const PositionPath& path = plan.segments[segment].path;
  const int least = plan.continues ? kWindowIntervals : kJointIntervals;
  double wanted = least;
  if (path.shape == PositionPath::Shape::kArc) wanted = kJointIntervals * path.angle_rad / kTurn_rad;
  if (path.shape == PositionPath::Shape::kSpline) {
    wanted = static_cast<double>(kPieceIntervals * (path.spline->points_mm().size() - 1));
  }
  const std::size_t spare = (plan.continues ? LawGrid::kSparePoints : kMoreOfFirst) / plan.count / 2;
  return std::clamp(static_cast<int>(rounded_up(wanted)), least, least + static_cast<int>(spare));
}

int LawGrid::first_intervals(const CartesianPlan& plan) const noexcept {
  const PositionPath::Shape shape = plan.segments[piece_.segment].path.shape;
  const bool between = piece_.part == Part::kBetween;
  const int for_joints = between ? joint_intervals(plan, piece_.segment) : kJointIntervals;
  if (with_ == With::kToolOnly) {
    if (between && shape == PositionPath::Shape::kLine) return kLineIntervals;
    const bool spline = between && shape == PositionPath::Shape::kSpline;
    return spline ? kToolIntervals * for_joints : kBentIntervals;
  }
  if (!plan.continues) return for_joints;
  const int most = between ? for_joints : kWindowCornerIntervals;
  const double wanted = (piece_.to - piece_.from) / kWindowInterval_mm;
  return wanted >= most ? most : 1 + static_cast<int>(wanted);
}

void LawGrid::append(SpeedLaw& law, const Point& point, bool stops) noexcept {
  Point next = point;
  if (with_ == With::kJoints) add_jolt(law, next);
  [[maybe_unused]] const bool appended = law.append(next.s, next.limits, stops);
  assert(appended);  // see step()
  last_ = next;
}

const CartesianSegment& LawGrid::owner(const CartesianPlan& plan) const noexcept {
  return plan.segments[piece_.segment + (piece_.part == Part::kSecondHalf ? 1 : 0)];
}

LawGrid::Busiest LawGrid::busiest(const LawLimits& limits, double x, double u) const noexcept {
  Busiest result;
  for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) {
    const LawLimits::Band& band = limits.bands[axis];
    const double speed = std::fabs(band.by_accel) * accel_rad_s2_[axis] * std::sqrt(x);
    const double share = std::max(speed / speed_rad_s_[axis], std::fabs(band.by_accel * u + band.by_square * x));
    if (share > result.share) result = {axis, share};
  }
  return result;
}

double LawGrid::most_of_joints(const LawLimits& limits, double length) const noexcept {
  double result = kLargestPathLimit;
  for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) {
    const double by_accel = std::fabs(limits.bands[axis].by_accel), by_square = std::fabs(limits.bands[axis].by_square);
    if (by_square > 0.0) result = std::min(result, 1.0 / by_square);
    if (!(by_accel > 0.0)) continue;
    result = std::min({result, length / by_accel, math::square(speed_rad_s_[axis] / (by_accel * accel_rad_s2_[axis]))});
  }
  return result;
}

}  // namespace armature
