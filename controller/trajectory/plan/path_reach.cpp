#include "controller/trajectory/plan/path_reach.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace armature {
namespace {

using Kind = PathProblem::Kind;

PathProblem problem_at(const CartesianPlan& plan, const Arm& arm, std::size_t index, double share) {
  const HeldTool tool = tool_sample(plan.segments[index], share, plan.tool_T_flange).tool;
  PathProblem problem{.segment = static_cast<std::uint8_t>(index), .at = share};
  if (tool.missing_mm > 0.0) {
    problem.kind = Kind::kUnreachable;
    problem.margin_mm = tool.missing_mm;
    return problem;
  }
  const IkTracking solution = arm.soonest(tool.base_T_tool * plan.tool_T_flange, plan.start);
  if (solution.status == IkStatus::kUnreachable) {
    problem.kind = Kind::kUnreachable;
    problem.margin_mm = solution.margin_mm;
  } else if (solution.status == IkStatus::kOrientation) {
    problem.kind = Kind::kOrientation;
    problem.residual_rad = solution.residual_rad;
  }
  return problem;
}

// True when neither the segment nor its neighbours rotate, so that the flange moves like the tool. kFollowing without a
// change of pitch or roll also turns about axis 1, which does not change the reach.
bool keeps_orientation_around(const CartesianPlan& plan, std::size_t index) {
  for (std::size_t i = index > 0 ? index - 1 : 0; i < plan.count && i <= index + 1; ++i) {
    if (turn_angle_rad(plan.segments[i]) > 0.0) return false;
  }
  return true;
}

// Calls visit(share) for each requested point of the path, in their order, until it returns false.
template <class Visit>
void visit_points(const SegmentRequest& request, const PositionPath& path, Visit visit) {
  if (request.kind == SegmentRequest::Kind::kArc || request.kind == SegmentRequest::Kind::kCircle) {
    if (!visit(share_of(path, request.via_mm))) return;
  }
  if (request.kind == SegmentRequest::Kind::kCircle && !visit(share_of(path, request.target.position_mm))) return;
  for (std::size_t i = 0; request.kind == SegmentRequest::Kind::kSpline && i < request.through_mm.size(); ++i) {
    if (!visit(path.spline->length_to_mm(i + 1) / path.length_mm)) return;
  }
  (void)visit(1.0);
}

std::size_t points_of(const SegmentRequest& request) {
  switch (request.kind) {
    case SegmentRequest::Kind::kLine:
    case SegmentRequest::Kind::kArcAbout:
      return 1;
    case SegmentRequest::Kind::kArc:
      return 2;
    case SegmentRequest::Kind::kCircle:
      return 3;
    case SegmentRequest::Kind::kSpline:
      return request.through_mm.size() + 1;
  }
  return 1;
}

}  // namespace

std::size_t points_of(std::span<const SegmentRequest> chain) noexcept {
  std::size_t points = 0;
  for (const SegmentRequest& request : chain) points += points_of(request);
  return points;
}

PathProblem find_unreachable(const CartesianPlan& plan, const Arm& arm,
                             std::span<const SegmentRequest> chain) noexcept {
  for (std::size_t i = 0; i < plan.count; ++i) {
    const SegmentRequest& request = chain[i];
    const PositionPath& path = plan.segments[i].path;
    const double blend_before_mm = i > 0 ? chain[i - 1].blend_mm : 0.0;
    const double blend_after_mm = i + 1 < plan.count ? request.blend_mm : 0.0;
    const double before_mm = i > 0 ? plan.segments[i - 1].corner : 0.0;
    const double after_mm = plan.segments[i].corner;
    const double most_blend_mm = std::max(blend_before_mm, blend_after_mm);

    PathProblem found;
    visit_points(request, path, [&](double share) {
      const bool on_the_path = share * path.length_mm >= before_mm && (1.0 - share) * path.length_mm >= after_mm;
      const PathProblem problem = problem_at(plan, arm, i, share);
      const bool beyond_blend = keeps_orientation_around(plan, i) && problem.margin_mm > most_blend_mm;
      if (problem.kind != Kind::kNone && (on_the_path || beyond_blend)) found = problem;
      return found.kind == Kind::kNone;
    });
    if (found.kind != Kind::kNone) return found;
  }
  return {};
}

}  // namespace armature
