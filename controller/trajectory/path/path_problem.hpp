// Why a path cannot be executed, and where.
#pragma once

#include <cstdint>

#include "controller/base/members.hpp"

namespace armature {

struct PathProblem {
  enum class Kind : std::uint8_t {
    kNone,
    kNoCircle,     // the three points of an arc do not determine a circle, or the start of an arc is on its axis
    kUnreachable,  // from `at` on; `margin_mm` is the largest distance beyond the reach on the rest of the segment. For
                   // a requested point (find_unreachable()), `at` and `margin_mm` are those of the point
    kOutsideLimits,  // joint `axis` would leave its limits
    kOrientation,    // a five-joint arm misses the orientation from `at` on; `residual_rad` is the largest error on the
                     // rest of the segment
    kTooFast,  // joint `axis` would need more than the allowed `stretch` of the time, or more in every pass; `singular`
               // names a singularity near the path, if there is one
    kTooLong,  // longer than kLongestSegment
    kTooManySegments,     // more than a plan can contain, or more splines or outputs
    kInvalidLimits,       // a limit of the tool that is not above 0, beyond kLargestPathLimit or NaN
    kInvalidPose,         // the pose at `at` is not finite or has no valid rotation
    kNoConfiguration,     // a pose that has no solution in the requested `configuration`
    kOtherConfiguration,  // the path ends with another `configuration` than requested; `axis` if it has other turns
    kNoSpline,            // the points of a spline are too close, or the curve would turn back on the spot
    kOutputOutside,       // an output of the segment is before the start or behind the end of the chain
  };
  Kind kind = Kind::kNone;
  std::uint8_t segment = 0;   // index in the request
  double at = 0.0;            // position as a share of that segment's path, 0..1
  std::uint8_t axis = 0;      // 1..6; 0 if no joint caused it (kTooFast: the tool itself, in a corner)
  std::uint8_t singular = 0;  // mask of Singularity
  double margin_mm = 0.0;
  double residual_rad = 0.0;
  double stretch = 1.0;
  // kOutsideLimits: the angle that the joint would need. refusal_of() adds the limit next to it, and makes both equal
  // for a joint that would pass the limit only between two set-points.
  double angle_rad = 0.0;
  double limit_rad = 0.0;
  std::uint8_t configuration = 0;  // mask of ConfigurationPart: the parts that are not as requested
  ARMATURE_MEMBERS(PathProblem, kind, segment, at, axis, singular, margin_mm, residual_rad, stretch, angle_rad,
                   limit_rad, configuration)
};

}  // namespace armature
