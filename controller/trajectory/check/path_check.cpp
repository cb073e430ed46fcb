#include "controller/trajectory/check/path_check.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "controller/base/math.hpp"
#include "controller/base/timebase.hpp"
#include "controller/kinematics/branch_choice.hpp"

namespace armature {
namespace {

double power(double x, std::size_t order) {
  return order == 1 ? x : order == 2 ? x * x : x * x * x;
}
// The stretch of the law that takes a speed (order 1), an acceleration or a jerk that is `excess` times too high back
// to its limit. A jerk changes as an acceleration does, because the time of the moving average stays when its law is
// slower.
double stretch_of(double excess, std::size_t order) {
  return order == 1 ? excess : std::sqrt(excess);
}

constexpr std::size_t kTwistingJoints[]{3, 5};  // joints 4 and 6
constexpr std::int64_t kWristTicks = 3;         // differences that contain the tick in the wrist singularity
constexpr double kWristShare[]{1.0, 0.5, 0.3};  // of the limits of joints 4 and 6 there, by order

bool empty(const CartesianSegment& segment) {
  return segment.duration == Ticks{0};
}

// True when the plan stands still at this tick: at its ends and at exact stops.
bool rests_at(const CartesianPlan& plan, std::int64_t tick) {
  if (tick <= 0 || tick >= plan.duration.value()) return true;
  for (std::size_t i = 1; i < plan.count; ++i) {
    if (plan.segments[i].start.value() == tick && end_of(plan.segments[i - 1]).value() == tick) return true;
  }
  return false;
}

}  // namespace

PathCheck::PathCheck(const RobotModel& robot) noexcept : axis_count_{robot.axis_count} {
  for (std::size_t axis = 0; axis < axis_count_; ++axis) {
    const AxisModel& model = robot.axes[axis];
    const CheckedLimits limits{model};
    limit_[0][axis] = limits.speed_rad_s * kTickSeconds;
    limit_[1][axis] = limits.accel_rad_s2 * power(kTickSeconds, 2);
    limit_[2][axis] = limits.jerk_rad_s3 * power(kTickSeconds, 3);
    const double beyond_rad = model.max_accel_rad_s2 * power(kTickSeconds, 2) / 8.0 - kLimitTolerance_rad;
    lowest_[axis] = model.min_rad + beyond_rad;
    highest_[axis] = model.max_rad - beyond_rad;
  }
}

void PathCheck::begin(const JointAngles& joints, const ToolSample& tool) noexcept {
  oldest_ = 0;
  restart(0, joints, tool);
}

void PathCheck::restart(std::int64_t tick, const JointAngles& joints, const ToolSample& tool) noexcept {
  tick_ = tick;
  joints_ = joints;
  difference_ = {};
  tool_.fill(tool);
  tool_between_.fill(tool);
  step_ = {};
  accel_ = {};
  before_.fill(joints);
  wrist_until_ = -1;
  axis_at_its_limit_ = 0;
  jerk_share_ = 0.0;
  latest_ = {};
}

void PathCheck::add(const CartesianPlan& plan, const JointAngles& joints, const ToolSample& tool,
                    bool through_wrist) noexcept {
  ++tick_;
  jerk_share_ = 0.0;
  for (std::size_t axis = 0; axis < axis_count_; ++axis) {
    const double speed = (joints[axis] - joints_[axis]).value();
    const double accel = speed - difference_[0][axis];
    difference_[2][axis] = accel - difference_[1][axis];
    difference_[1][axis] = accel;
    difference_[0][axis] = speed;
  }
  step_ = {difference_[0], step_[0], step_[1]};
  accel_ = {difference_[1], accel_[0], accel_[1], accel_[2]};
  before_ = {joints_, before_[0]};
  joints_ = joints;
  check_turning_points(plan);
  tool_ = {tool, tool_[0], tool_[1], tool_[2]};

  while (oldest_ + 1 < plan.count &&
         end_of(plan.segments[oldest_]).value() <= tick_ - static_cast<std::int64_t>(kOldest)) {
    ++oldest_;
  }
  check_wrist(plan, through_wrist);
  for (std::size_t order = 1; order <= kOrders; ++order) {
    check_joints(plan, order, segments_around(plan, order), difference_[order - 1], static_cast<double>(tick_));
  }
  Excess here;
  check_tool(here, limits_around(plan, 2), tool_);
  check_tool_jerk(here, plan, kOrders, tool_);
  note(here, static_cast<double>(tick_) - 3.0, static_cast<double>(tick_));
}

void PathCheck::add_between(const CartesianPlan& plan, double tick, const std::array<JointAngles, 4>& joints) noexcept {
  for (std::size_t order = 2; order <= kOrders; ++order) {
    const std::optional<Range> around = segments_between(plan, order, tick);
    if (!around) continue;
    PerAxis<double> difference{};
    for (std::size_t axis = 0; axis < axis_count_; ++axis) {
      const auto q = [&](std::size_t back) { return joints[back][axis].value(); };
      difference[axis] = order == 2 ? q(0) - 2.0 * q(1) + q(2) : q(0) - 3.0 * (q(1) - q(2)) - q(3);
    }
    check_joints(plan, order, *around, difference, tick);
  }
}

void PathCheck::add_tool_between(const CartesianPlan& plan, double tick,
                                 const std::array<ToolSample, 3>& tool) noexcept {
  const std::optional<Range> around = segments_between(plan, 2, tick);
  if (!around) return;
  Excess here;
  check_tool(here, largest_limits(plan, *around), tool);
  note(here, tick - 2.0, tick);
}

std::optional<PathCheck::Range> PathCheck::segments_between(const CartesianPlan& plan, std::size_t order,
                                                            double tick) noexcept {
  const double since = tick - static_cast<double>(order);
  std::optional<Range> around;
  for (std::size_t i = 0; i < plan.count; ++i) {
    const CartesianSegment& segment = plan.segments[i];
    const auto start = static_cast<double>(segment.start.value());
    const auto end = static_cast<double>(end_of(segment).value());
    if (empty(segment) || start >= tick || end <= since) continue;
    around = Range{.first = around ? around->first : i, .last = i};
  }
  return around;
}

void PathCheck::finish(const CartesianPlan& plan) noexcept {
  for (std::size_t i = 0; i < kOrders; ++i) add(plan, joints_, tool_[0]);
}

// The segments that are active somewhere in the last `order` ticks.
PathCheck::Range PathCheck::segments_around(const CartesianPlan& plan, std::size_t order) const noexcept {
  Range range{oldest_, oldest_};
  const std::int64_t since = tick_ - static_cast<std::int64_t>(order);
  while (range.first + 1 < plan.count &&
         (empty(plan.segments[range.first]) || end_of(plan.segments[range.first]).value() <= since) &&
         plan.segments[range.first + 1].start.value() < tick_) {
    ++range.first;
  }
  range.last = range.first;
  for (std::size_t i = range.first + 1; i < plan.count && plan.segments[i].start.value() < tick_; ++i) {
    if (!empty(plan.segments[i])) range.last = i;
  }
  return range;
}

void PathCheck::check_joints(const CartesianPlan& plan, std::size_t order, const Range& around,
                             const PerAxis<double>& difference, double tick) noexcept {
  const auto segments = std::span{plan.segments}.subspan(around.first, around.last - around.first + 1);
  const auto jumps = [](const CartesianSegment& segment) { return segment.profile != ProfileKind::kSCurve; };
  if (order == 3 && std::any_of(segments.begin(), segments.end(), jumps)) return;
  double share = order == 2 ? 0.0 : 1.0;
  for (const CartesianSegment& segment : segments) {
    if (order == 2) share = std::max(share, segment.limits.joint_accel);
  }
  Excess here;
  for (std::size_t axis = 0; axis < axis_count_; ++axis) {
    const double size = std::fabs(difference[axis]);
    const double limit = share * limit_[order - 1][axis];
    record(here, stretch_of(size / limit, order), axis + 1);
    if (order == 3) jerk_share_ = std::max(jerk_share_, size / limit);
  }
  note(here, tick - static_cast<double>(order), tick);
}

void PathCheck::check_wrist(const CartesianPlan& plan, bool through_wrist) noexcept {
  if (through_wrist) wrist_until_ = tick_ + kWristTicks;
  if (tick_ > wrist_until_) return;
  const std::size_t index = segments_around(plan, 2).last;
  Excess here;
  const auto check = [&](std::size_t order, std::size_t axis, double difference) {
    const double size = std::fabs(difference), limit = kWristShare[order - 1] * limit_[order - 1][axis];
    record(here, stretch_of(size / limit, order), axis + 1);
  };
  const bool with_jerk = plan.segments[index].profile == ProfileKind::kSCurve;
  const std::size_t past =
      through_wrist ? accel_.size() - 1 : 1;  // older differences not checked with these limits yet
  for (const std::size_t axis : kTwistingJoints) {
    for (std::size_t i = 0; i < past; ++i) check(2, axis, accel_[i][axis]);
    for (std::size_t i = 0; with_jerk && i < past; ++i) check(3, axis, accel_[i][axis] - accel_[i + 1][axis]);
  }
  const auto tick = static_cast<double>(tick_);
  note(here, tick - static_cast<double>(past + 1), tick);
}

// Checks between two ticks ago and one tick ago. Only a joint that approaches and then moves away turns round there.
void PathCheck::check_turning_points(const CartesianPlan& plan) noexcept {
  for (std::size_t axis = 0; axis < axis_count_; ++axis) {
    const double a = before_[1][axis].value(), b = before_[0][axis].value();
    const bool high = std::max(a, b) > highest_[axis], low = std::min(a, b) < lowest_[axis];
    if (!high && !low) continue;
    const double came = rests_at(plan, tick_ - 2) ? 0.0 : step_[2][axis];
    const double goes = rests_at(plan, tick_ - 1) ? 0.0 : step_[0][axis];
    if ((high && came > 0.0 && goes < 0.0) || (low && came < 0.0 && goes > 0.0)) {
      axis_at_its_limit_ = static_cast<std::uint8_t>(axis + 1);
    }
  }
}

PathCheck::Place PathCheck::take_latest() noexcept {
  return std::exchange(latest_, Place{});
}

void PathCheck::note(const Excess& excess, double from_tick, double to_tick) noexcept {
  if (!(excess.stretch > 1.0)) return;
  if (latest_.stretch > 1.0) {
    from_tick = std::min(from_tick, latest_.from_tick);
    to_tick = std::max(to_tick, latest_.to_tick);
  }
  if (excess.stretch > latest_.stretch) {
    latest_.stretch = excess.stretch;
    latest_.axis = excess.axis;
  }
  latest_.from_tick = from_tick;
  latest_.to_tick = to_tick;
}

void PathCheck::check_tool(Excess& worst, const PathLimits& limits, std::span<const ToolSample> tool) noexcept {
  const auto check = [&](double size, double most, std::size_t order) {
    const double tolerance = order == 1 ? kSpeedTolerance : kToolTolerance, rounding = order == 1 ? kRounding : 0.0;
    const double limit = (1.0 + tolerance) * most * power(kTickSeconds, order) + rounding;
    record(worst, stretch_of(size / limit, order), 0);
  };
  const auto position_mm = [&](std::size_t past) { return tool[past].tool.base_T_tool.position_mm; };
  const Eigen::Vector3d step = position_mm(0) - position_mm(1), step_before = position_mm(1) - position_mm(2);
  const Eigen::Vector3d turn = limited_turn(tool[1], tool[0]), turn_before = limited_turn(tool[2], tool[1]);
  check(step.norm(), limits.speed_mm_s, 1);
  check((step - step_before).norm(), limits.accel_mm_s2, 2);
  check(turn.norm(), limits.turn_speed_rad_s, 1);
  check((turn - turn_before).norm(), limits.turn_accel_rad_s2, 2);
}

PathLimits PathCheck::limits_around(const CartesianPlan& plan, std::size_t order) const noexcept {
  return largest_limits(plan, segments_around(plan, order));
}

PathLimits PathCheck::largest_limits(const CartesianPlan& plan, const Range& around) noexcept {
  PathLimits limits = plan.segments[around.first].limits;
  for (std::size_t i = around.first + 1; i <= around.last; ++i) limits = larger(limits, plan.segments[i].limits);
  return limits;
}

void PathCheck::add_tool_between(const CartesianPlan& plan, const ToolSample& tool) noexcept {
  tool_between_ = {tool, tool_between_[0], tool_between_[1], tool_between_[2]};
  Excess here;
  check_tool(here, limits_around(plan, 3), tool_between_);
  check_tool_jerk(here, plan, kOldest, tool_between_);
  const double tick = static_cast<double>(tick_) - 0.5;
  note(here, tick - 3.0, tick);
}

void PathCheck::check_tool_jerk(Excess& worst, const CartesianPlan& plan, std::size_t ticks,
                                const ToolSamples& tool) noexcept {
  const Range around = segments_around(plan, ticks);
  for (std::size_t i = around.first; i <= around.last; ++i) {
    if (plan.segments[i].profile != ProfileKind::kSCurve) return;
  }
  const PathLimits limits = limits_around(plan, ticks);
  const auto check = [&](const Eigen::Vector3d& first, const Eigen::Vector3d& second, const Eigen::Vector3d& third,
                         double most) {
    const double size = (first - 2.0 * second + third).norm();
    const double limit = (1.0 + kJerkTolerance) * most * power(kTickSeconds, 3);
    record(worst, stretch_of(size / limit, 3), 0);
    jerk_share_ = std::max(jerk_share_, size / limit);
  };
  const auto step = [&](std::size_t past) -> Eigen::Vector3d {
    return tool[past].tool.base_T_tool.position_mm - tool[past + 1].tool.base_T_tool.position_mm;
  };
  check(step(0), step(1), step(2), limits.jerk_mm_s3);
  check(limited_turn(tool[1], tool[0]), limited_turn(tool[2], tool[1]), limited_turn(tool[3], tool[2]),
        limits.turn_jerk_rad_s3);
}

void PathCheck::record(Excess& worst, double stretch, std::size_t axis_number) noexcept {
  if (stretch > worst.stretch) worst = {.stretch = stretch, .axis = static_cast<std::uint8_t>(axis_number)};
}

}  // namespace armature
