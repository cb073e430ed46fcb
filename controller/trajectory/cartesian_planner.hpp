// Plans motions of the tool and checks them before the first pulse: every set-point that the motion loop will send is
// computed here, at every tick, against reach, joint limits, joint speed, acceleration and jerk and the 4 Mpps of the
// pulse generators. Where a joint would be too fast, the time laws of the segments that are then active are stretched,
// the path stays; beyond `max_stretch` the motion is refused.
//
// The planner works in slices, so that its core can listen in between.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/cartesian_plan.hpp"
#include "controller/trajectory/time_law.hpp"

namespace armature {

// Limits of the tool's motion along the path. Turning has its own, because a pure rotation has no length.
struct PathLimits {
  double speed_mm_s = 0.0;   // > 0, as all of these
  double accel_mm_s2 = 0.0;  // of the tool centre point, centripetal part included
  double jerk_mm_s3 = 0.0;   // kSCurve only
  double turn_speed_rad_s = 0.0;
  double turn_accel_rad_s2 = 0.0;
  double turn_jerk_rad_s3 = 0.0;  // kSCurve only
};

// One segment as it was asked for, in the base frame. It begins where the one before ends.
struct SegmentRequest {
  enum class Kind : std::uint8_t { kLine, kArc, kCircle };
  Kind kind = Kind::kLine;
  Eigen::Vector3d via_mm = Eigen::Vector3d::Zero();  // kArc, kCircle: second point
  Transform target{};  // base_T_tool at the end. kCircle: its position is the third point of the circle
  PathLimits limits{};
  ProfileKind profile = ProfileKind::kTrapezoid;
  double blend_mm = 0.0;  // how far from the corner to the next segment the path may be left; 0: exact stop
};

// Why a path cannot be driven, and where.
struct PathProblem {
  enum class Kind : std::uint8_t {
    kNone,
    kNoCircle,       // the three points of an arc do not determine a circle
    kUnreachable,    // by margin_mm
    kOutsideLimits,  // joint `axis` would leave its limits
    kOrientation,    // a five-joint arm misses the orientation by residual_rad
    kTooFast,        // joint `axis` would need `stretch` times the time, more than allowed; `singular` names the
                     // singularity that the path passes, if there is one
    kTooLong,        // more than kLongestMove
  };
  Kind kind = Kind::kNone;
  std::uint8_t segment = 0;   // index in the request
  double at = 0.0;            // share of that segment's path, 0..1
  std::uint8_t axis = 0;      // 1..6
  std::uint8_t singular = 0;  // mask of Singularity
  double margin_mm = 0.0;
  double residual_rad = 0.0;
  double stretch = 1.0;
};

class CartesianPlanner {
 public:
  enum class Progress : std::uint8_t { kIdle, kWorking, kDone, kRefused };

  // References must outlive the planner. `max_stretch` >= 1.
  CartesianPlanner(const RobotModel& robot, const Arm& arm, const Transform& flange_T_tool,
                   double max_stretch) noexcept;
  CartesianPlanner(const CartesianPlanner&) = delete;
  CartesianPlanner& operator=(const CartesianPlanner&) = delete;

  // Begins with a chain of 1..kMostSegments segments from where the arm stands. Gives up what it was doing.
  void begin(const JointAngles& start, std::span<const SegmentRequest> chain) noexcept;
  void give_up() noexcept;

  // Computes up to `samples` set-points.
  Progress work(std::size_t samples) noexcept;
  [[nodiscard]] Progress progress() const noexcept;

  [[nodiscard]] const CartesianPlan& plan() const noexcept;   // kDone
  [[nodiscard]] const PathProblem& problem() const noexcept;  // kRefused

 private:
  // To be designed by the implementation.
};

}  // namespace armature
