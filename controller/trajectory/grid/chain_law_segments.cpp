// The end of the planning of a law: what the plan gets of it, and how much the joints slow down its segments.
#include <algorithm>
#include <cmath>

#include "controller/base/rounding.hpp"
#include "controller/base/timebase.hpp"
#include "controller/trajectory/cartesian/path_corners.hpp"
#include "controller/trajectory/grid/chain_law.hpp"
#include "controller/trajectory/grid/tool_limits.hpp"

namespace armature {
namespace {

// The grids of both laws differ; a segment that takes longer by less counts as not slowed down.
constexpr double kNotSlower = 2e-3;
constexpr double kTickRounding = 1e-3;

// The start of a segment by the table, which is the end of the one before.
void set_start(CartesianPlan& plan, std::size_t i) noexcept {
  CartesianSegment& segment = plan.segments[i];
  const double ticks = plan.table.time_at(segment.from) / kTickSeconds;
  const bool in_motion = i > 0 && joint_after(plan, i - 1) != PathJoint::kStop;
  Ticks end_before{};
  if (in_motion) {
    end_before = Ticks{static_cast<std::int64_t>(rounded_up(ticks))};
    segment.start = end_before - Ticks{1};
  } else {  // runs begin with a tick
    segment.start = end_before = Ticks{static_cast<std::int64_t>(rounded_up(ticks - kTickRounding))};
  }
  if (i > 0) plan.segments[i - 1].duration = end_before - plan.segments[i - 1].start;
}

}  // namespace

void ChainLaw::finish(CartesianPlan& plan) noexcept {
  set_table(plan);
  plan.duration = plan.table.duration();
  for (std::size_t i = 0; i < plan.count; ++i) {
    if (plan.continues && plan.segments[i].from <= plan.table.kept_end().s) continue;  // it has started before
    set_stretch(plan, i);
    set_start(plan, i);
  }
  CartesianSegment& last = plan.segments[plan.count - 1];
  last.duration = plan.duration - last.start;
  if (!smooth_ || plan.continues) return;
  // The jerk of a joint may make a passage beside a singularity slower than its speed and acceleration by far.
  for (std::size_t i = 0; i < plan.count; ++i) {
    CartesianSegment& segment = plan.segments[i];
    if (segment.duration > kLongestSegment && tool_s_[i] > 0.0)
      segment.stretch = seconds(segment.duration) / tool_s_[i];
  }
}

void ChainLaw::set_table(CartesianPlan& plan) const noexcept {
  if (smooth_) {
    smooth_law_.write(plan.table);
  } else if (plan.continues) {
    plan.table.continue_with(law_);
  } else {
    plan.table.assign(law_);
  }
}

void ChainLaw::set_stretch(CartesianPlan& plan, std::size_t i) const noexcept {
  CartesianSegment& segment = plan.segments[i];
  double slower = 1.0;
  if (plan.continues) {
    // What lower() has slowed down does not count.
    if (segment.from <= law_.s(0) || (smooth_ && lowered_)) return;
    slower = most_slowed(plan, i);
  } else if (tool_s_[i] > 0.0) {
    slower = joint_s_[i] / tool_s_[i];
  }
  segment.stretch = slower > 1.0 + kNotSlower ? slower : 1.0;
  segment.stretched_for = 0;
}

void ChainLaw::measure(const CartesianPlan& plan,
                       std::array<double, CartesianPlan::kMaxSegments>& time_s) const noexcept {
  time_s.fill(0.0);
  std::size_t segment = 0;
  for (std::size_t i = 0; i + 1 < law_.size(); ++i) {
    const double step = law_.s(i + 1) - law_.s(i);
    if (!(step > 0.0)) continue;
    const double middle = law_.s(i) + 0.5 * step;
    while (segment + 1 < plan.count && middle > plan.segments[segment].from + plan.segments[segment].length) ++segment;
    time_s[segment] += law_.duration_s(i);
  }
}

double ChainLaw::most_slowed(const CartesianPlan& plan, std::size_t segment) const noexcept {
  const CartesianSegment& path = plan.segments[segment];
  const double most = largest_square(limits_of_tool(path, 0.0, path.length));
  double slower = 1.0;
  for (std::size_t i = law_.point_at(path.from); i < law_.size() && law_.s(i) <= path.from + path.length; ++i) {
    if (law_.s(i) < path.from) continue;
    // In a corner the tool alone must be slower, too.
    LawLimits tool = law_.limits(i);
    tool.bands = {};
    tool.most_square = most;
    slower = std::max(slower, largest_square(tool) / grid_.most_of_joints(law_.limits(i), path.length));
  }
  return std::sqrt(slower);
}

}  // namespace armature
