// Why a path cannot be driven, and where.
#pragma once

#include <cstdint>

namespace armature {

struct PathProblem {
  enum class Kind : std::uint8_t {
    kNone,
    kNoCircle,       // the three points of an arc do not determine a circle
    kUnreachable,    // from `at` on; `margin_mm` is the most by which the rest of the segment is beyond the reach.
                     // Where a point that was asked for is (find_unreachable()), `at` and `margin_mm` are that point's
    kOutsideLimits,  // joint `axis` would leave its limits
    kOrientation,    // a five-joint arm misses the orientation from `at` on, on the rest of the segment by
                     // `residual_rad` at most
    kTooFast,        // joint `axis` would need `stretch` times the time, more than allowed, or would ask for more again
                     // and again; `singular` names the singularity that the path passes, if there is one
    kTooLong,        // more than kLongestSegment
    kTooManySegments,  // more than a plan holds
    kInvalidLimits,    // a limit of the tool that is not above 0, beyond kLargestPathLimit or no number
    kInvalidPose,      // `at` is no pose: not finite, or no rotation
  };
  Kind kind = Kind::kNone;
  std::uint8_t segment = 0;   // index in the request
  double at = 0.0;            // share of that segment's path, 0..1
  std::uint8_t axis = 0;      // 1..6; 0 where it is not a joint (kTooFast: the tool itself, in a corner)
  std::uint8_t singular = 0;  // mask of Singularity
  double margin_mm = 0.0;
  double residual_rad = 0.0;
  double stretch = 1.0;
};

}  // namespace armature
