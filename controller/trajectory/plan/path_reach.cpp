#include "controller/trajectory/plan/path_reach.hpp"

#include <algorithm>
#include <array>
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
  const IkSolutions solutions = arm.inverse(tool.base_T_tool * plan.tool_T_flange, plan.start);
  if (solutions.status == IkStatus::kUnreachable) {
    problem.kind = Kind::kUnreachable;
    problem.margin_mm = solutions.margin_mm;
  } else if (solutions.status == IkStatus::kOrientation) {
    problem.kind = Kind::kOrientation;
    problem.residual_rad = solutions.residual_rad;
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

// The segment passes its via point.
bool has_via(SegmentRequest::Kind kind) {
  return kind == SegmentRequest::Kind::kArc || kind == SegmentRequest::Kind::kCircle;
}

}  // namespace

std::size_t points_of(std::span<const SegmentRequest> chain) noexcept {
  std::size_t points = 0;
  for (const SegmentRequest& request : chain) {
    points += request.kind == SegmentRequest::Kind::kCircle ? 3u : has_via(request.kind) ? 2u : 1u;
  }
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

    std::array<double, 3> shares{};
    std::size_t count = 0;
    if (has_via(request.kind)) shares[count++] = share_of(path, request.via_mm);
    if (request.kind == SegmentRequest::Kind::kCircle) shares[count++] = share_of(path, request.target.position_mm);
    shares[count++] = 1.0;
    for (std::size_t k = 0; k < count; ++k) {
      const bool on_the_path =
          shares[k] * path.length_mm >= before_mm && (1.0 - shares[k]) * path.length_mm >= after_mm;
      const PathProblem problem = problem_at(plan, arm, i, shares[k]);
      if (problem.kind == Kind::kNone) continue;
      if (on_the_path || (keeps_orientation_around(plan, i) && problem.margin_mm > most_blend_mm)) return problem;
    }
  }
  return {};
}

}  // namespace armature
