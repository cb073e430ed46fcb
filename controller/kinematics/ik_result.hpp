// The results of an inverse kinematics. A result never contains a NaN, and no input is clamped without a report.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"

namespace armature {

// Joint angles in the vendor's convention, which limits and drives use. Axes that the arm does not have are 0.
using JointAngles = PerAxis<Radians>;

enum class IkStatus : std::uint8_t {
  kOk,
  kClamped,        // at the reach limit: beyond it by rounding only (1e-9 of the reach), and set to the limit
  kSingular,       // a solution, but some angle is free and is the previous one; `singular` names the singularity
  kUnreachable,    // `margin_mm` beyond the reach (too far or too near)
  kOutsideLimits,  // all solutions have a joint outside its limits; `axis` of the one that misses by least
  kOrientation,    // kFiveR: the orientation error with five joints, `residual_rad`, is more than max_projection_rad
  kInvalidInput,   // no rigid pose (see is_rigid in transform.hpp), or previous joints that are not valid angles
  kConfiguration,  // the pose has solutions, but none in the requested configuration; `configuration` says why
};
// True when a selected solution can be executed.
[[nodiscard]] constexpr bool solved(IkStatus status) noexcept {
  return status <= IkStatus::kSingular;
}

// Singular configurations, as a mask.
enum Singularity : std::uint8_t {
  kNotSingular = 0,
  kShoulderSingular = 1,  // kSixR: wrist centre on axis 1. kFiveR: tool point on axis 1 and approach parallel to it
  kWristSingular = 2,     // kSixR: axes 4 and 6 parallel
  kElbowSingular = 4,     // arm stretched or folded, within 1e-9 of the reach; no angle is free, two branches coincide
  kFoldedSingular = 8,    // folded back onto axis 2 (only with links of equal length): theta_2 is free
};

struct IkBranch {
  JointAngles joints{};           // theta mod 2 pi as joints, inside the limits if possible, see `within_limits`
  std::int8_t shoulder = 1;       // +1: theta_1 = atan2(p_y, p_x), -1: the arm reaches backwards
  std::int8_t elbow = 1;          // sign in theta_2 = gamma + elbow * beta (kSixR), gamma - elbow * beta (kFiveR)
  std::int8_t flip = 1;           // sign of sin(theta_5); 0 for kFiveR
  std::uint8_t singular = 0;      // mask of Singularity
  bool clamped = false;           // this branch is at the reach limit
  bool within_limits = false;     // every joint has a value + n * 360 deg inside its limits; `joints` contains those
  std::uint8_t outside_axis = 0;  // 1..6: otherwise the joint that exceeds its limits by most
};

// All branches of one pose, in the order shoulder (+, -) > elbow (+, -) > flip (+, -). Branches that do not exist are
// omitted (at the wrist singularity one flip stands for both).
struct IkSolutions {
  static constexpr std::size_t kMax = 8;

  std::array<IkBranch, kMax> branches{};
  std::size_t count = 0;
  int selected = -1;  // index of the branch whose joint move from the previous joints takes the least time; -1: none

  IkStatus status = IkStatus::kUnreachable;  // of the selected branch, or the reason why there is none
  std::uint8_t singular = 0;                 // mask of Singularity, of the selected branch
  std::uint8_t axis = 0;                     // kOutsideLimits: 1..6
  double angle_rad = 0.0;                    // kOutsideLimits: that this joint would need
  double margin_mm = 0.0;                    // kUnreachable: how far beyond the reach, > 0
  double residual_rad = 0.0;                 // kFiveR: rotation from the requested pose to the solved one, >= 0
  // kConfiguration: mask of ConfigurationPart. The requested sides that no solution has or, if each is possible by
  // itself, all that were requested.
  std::uint8_t configuration = 0;
};

// The one branch nearest to the arm's present joints, for samples of a path.
struct IkTracking {
  // Continuous along a path, even outside what may be planned, so that values between checked samples are close to
  // them: kOutsideLimits: the angles as they are; kUnreachable: the arm stretched (or folded) towards the pose;
  // kOrientation: projected. Only joints with a solved() status may be planned. Valid only with `found`;
  // with kOutsideLimits that of `axis` in any case.
  JointAngles joints{};
  bool found = false;  // false: kInvalidInput, or an approach normal to the plane of a five-joint arm
  IkStatus status = IkStatus::kUnreachable;
  std::uint8_t singular = 0;
  std::uint8_t axis = 0;
  double margin_mm = 0.0;
  double residual_rad = 0.0;
  std::uint8_t configuration = 0;  // Arm::soonest(): as in IkSolutions
};

// Distance of a configuration from each singularity: 0 (singular) .. 1. For kSixR det J = a2 k m_elbow (a2 + k)
// m_shoulder m_wrist, with k = hypot(a3, d4). A value that a family does not have is 1.
struct Manipulability {
  double shoulder = 1.0;  // |r| / (a2 + k): wrist centre from axis 1
  double elbow = 1.0;     // |sin(theta_3 - phi)|
  double wrist = 1.0;     // |sin(theta_5)|
};

}  // namespace armature
