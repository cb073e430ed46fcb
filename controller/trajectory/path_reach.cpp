#include "controller/trajectory/path_reach.hpp"

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

}  // namespace

PathProblem find_unreachable(const CartesianPlan& plan, const Arm& arm,
                             std::span<const SegmentRequest> chain) noexcept {
  for (std::size_t i = 0; i < plan.count; ++i) {
    const SegmentRequest& request = chain[i];
    const PositionPath& path = plan.segments[i].path;
    // Overlaps of segments take at most half of either.
    const double half_mm = 0.5 * path.length_mm;
    const double before_mm = i > 0 ? std::min(chain[i - 1].blend_mm, half_mm) : 0.0;
    const double after_mm = i + 1 < plan.count ? std::min(request.blend_mm, half_mm) : 0.0;

    std::array<double, 3> shares{};
    std::size_t count = 0;
    if (request.kind != SegmentRequest::Kind::kLine) shares[count++] = share_of(path, request.via_mm);
    if (request.kind == SegmentRequest::Kind::kCircle) shares[count++] = share_of(path, request.target.position_mm);
    shares[count++] = 1.0;
    for (std::size_t k = 0; k < count; ++k) {
      const bool on_the_path =
          shares[k] * path.length_mm >= before_mm && (1.0 - shares[k]) * path.length_mm >= after_mm;
      if (!on_the_path) continue;
      const PathProblem problem = problem_at(plan, arm, i, shares[k]);
      if (problem.kind != Kind::kNone) return problem;
    }
  }
  return {};
}

}  // namespace armature
