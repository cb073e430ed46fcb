// The part of CartesianPlanner that continues a plan while it is executed.
#include <algorithm>
#include <optional>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/cartesian/path_corners.hpp"
#include "controller/trajectory/cartesian/path_layout.hpp"
#include "controller/trajectory/grid/tool_limits.hpp"
#include "controller/trajectory/plan/cartesian_planner.hpp"

namespace armature {
namespace {

constexpr double kEnough = 0.8;  // of the square of the speed in a corner
constexpr int kMaxHalvings = 12;

// The mean deceleration at the end of a motion.
double braking(const TimeTable& table) {
  const TimeTable::Point from = table.passing(table.position(table.brakes_from_s()));
  const double way = table[table.size() - 1].s - from.s;
  return way > 0.0 ? 0.5 * from.speed * from.speed / way : 0.0;
}

// The square of the speed that the tool may have in a corner.
double most_square_in_corner(const CartesianPlan& plan, std::size_t first) {
  const CartesianSegment& segment = plan.segments[first];
  const double middle = segment.from + segment.length, run_length = run_around(plan, first);
  double result = kLargestPathLimit;
  for (const double share : {-0.6, -0.3, 0.0, 0.3, 0.6}) {
    const double s = middle + share * segment.corner;
    result = std::min(result, largest_square(limits_in_corner(plan, first, segment, s, run_length)));
  }
  return result;
}

std::size_t outputs_in(std::span<const SegmentRequest> segments) {
  std::size_t count = 0;
  for (const SegmentRequest& segment : segments) count += segment.outputs.count;
  return count;
}

}  // namespace

std::size_t CartesianPlanner::segments_over(double t_s) const noexcept {
  // With some ticks before, where the next plan is sampled too.
  const double s = plan_.table.position(t_s - seconds(CartesianPlan::kSharedTicks));
  std::size_t over = 0;
  while (over + 1 < plan_.count &&
         plan_.segments[over].from + plan_.segments[over].length + plan_.segments[over].corner <= s) {
    ++over;
  }
  return over;
}

double CartesianPlanner::continue_before_s() const noexcept {
  const auto [table, later_s] = law_.motion(plan_);
  const double brakes_s = table.brakes_from_s(), end = table[table.size() - 1].s;
  // With the longest corner behind the last segment, and the same way to brake.
  const double corner = end - 0.5 * plan_.segments[plan_.count - 1].length;
  return later_s + std::min(brakes_s, table.time_at(corner - (end - table.position(brakes_s))));
}

std::size_t CartesianPlanner::segments_left(Ticks tick) const noexcept {
  // The origin of the next plan is a whole tick.
  return plan_.count - segments_over(seconds(tick - CartesianPlan::kSharedTicks - Ticks{1}));
}

std::size_t CartesianPlanner::room(Ticks earliest) const noexcept {
  if (!can_continue()) return 0;
  return std::min(CartesianPlan::kMaxSegments - segments_left(earliest), law_.room(plan_, seconds(earliest)));
}

std::size_t CartesianPlanner::room_for_outputs(Ticks earliest) const noexcept {
  return outputs_.room(earliest - CartesianPlan::kSharedTicks - Ticks{1});
}

bool CartesianPlanner::extend(Ticks earliest, double blend_mm, std::span<const SegmentRequest> added) noexcept {
  if (added.empty() || added.size() > room(earliest)) return false;
  if (outputs_in(added) > room_for_outputs(earliest)) return false;
  const auto may_not = [this](const SegmentRequest& request) {
    return !may_continue(request) || !may_add(request.profile);
  };
  if (std::any_of(added.begin(), added.end(), may_not)) return false;
  if (plan_.segments[plan_.count - 1].length == 0.0) return false;
  const std::optional<ChainLaw::Joint> joint = law_.joint_at(plan_, seconds(earliest));
  if (!joint) return false;
  const double joint_ticks = joint->passing.t_s / kTickSeconds;
  const auto origin = std::max(Ticks{static_cast<std::int64_t>(joint_ticks)} - CartesianPlan::kSharedTicks, Ticks{});
  inverses_ = 0;
  first_work_ = {};
  const double deceleration = braking(law_.motion(plan_).table);
  const JointAngles start = pass_.joints_at(plan_, origin.value(), inverses_);
  const double from_s = seconds(origin) - seconds(CartesianPlan::kSharedTicks);
  // A smooth law has a constant speed before it brakes.
  const double before_braking = joint->passing.speed * law_.tau_s();
  if (!law_.keep(plan_, *joint, from_s, origin)) return false;

  progress_ = Progress::kWorking;
  chain_ = {};
  bends_stage_ = Bends::kDone;  // those of the present plan stay
  passes_ = passes_of_chain_ = 0;
  plan_.start = start;
  move_origin(origin, joint->passing.t_s);
  const std::size_t last = plan_.count - 1;
  const double end_s = plan_.segments[last].from + plan_.segments[last].length;
  outputs_.add(plan_.count, added);
  problem_ = add_segments(plan_, plane_, added);
  if (problem_.kind == PathProblem::Kind::kNone) {
    add_corners(plan_, last, blend_mm, end_s - joint->passing.s, added);
    // The motion must have time to brake before the corner at its present end.
    const double square = joint->passing.speed * joint->passing.speed;
    double& corner = plan_.segments[last].corner;
    for (int i = 0; i < kMaxHalvings && corner > 0.0; ++i) {
      const double way = end_s - corner - joint->passing.s - before_braking;
      const double left = square - 2.0 * deceleration * way;
      if (left <= kEnough * most_square_in_corner(plan_, last)) break;
      corner *= 0.5;
    }
  }
  if (problem_.kind == PathProblem::Kind::kNone && !outputs_.on_own_segments(plan_)) {
    problem_.kind = PathProblem::Kind::kOutputOutside;
  }
  if (problem_.kind != PathProblem::Kind::kNone || !law_.has_room_behind(plan_, last)) {
    progress_ = Progress::kRefused;
    return true;
  }
  planning_law_ = true;
  law_.extend(plan_, last, end_s);
  return true;
}

// The plan from tick `origin` on, as a plan that continues the present one.
void CartesianPlanner::move_origin(Ticks origin, double same_until_s) noexcept {
  const std::size_t over = segments_over(0.0);
  std::move(plan_.segments.begin() + static_cast<std::ptrdiff_t>(over),
            plan_.segments.begin() + static_cast<std::ptrdiff_t>(plan_.count), plan_.segments.begin());
  plan_.count -= over;
  plan_.dropped = over;
  plan_.outputs_over = outputs_.move_origin(origin, same_until_s / kTickSeconds, over);
  plan_.known = plan_.count;
  for (std::size_t i = 0; i < plan_.count; ++i) plan_.segments[i].start = plan_.segments[i].start - origin;
  plan_.origin = origin;
  plan_.same_until_ticks = same_until_s / kTickSeconds - static_cast<double>(origin.value());
  plan_.continues = true;
  plan_.after_unasked_stop = false;
}

}  // namespace armature
