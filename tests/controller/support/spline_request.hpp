// Requests for splines.
#pragma once

#include <vector>

#include "tests/controller/support/path_rig.hpp"

namespace armature::test {

// Through the points, which must outlive the request, to the target.
inline SegmentRequest spline_to(const std::vector<Eigen::Vector3d>& points, const Transform& target,
                                const PathLimits& limits, ProfileKind profile = ProfileKind::kTrapezoid) {
  SegmentRequest request = line_to(target, limits, 0.0, profile);
  request.kind = SegmentRequest::Kind::kSpline;
  request.through_mm = points;
  return request;
}

}  // namespace armature::test
