// The vertical plane of a five-axis arm (five_r.hpp) and its tool: the orientations that the arm can hold at a tool
// point, expressed by the two free angles.
//
// The flange and its approach are in one vertical plane through axis 1. A tool that is not on the approach may be
// outside the plane by `aside`, which depends on roll and pitch only. The plane's heading h then follows from the tool
// point p, and the tool point is met exactly for any tool:
//   Rz(h) (x, aside) = (p_x, p_y),  x = +sqrt(p_x^2 + p_y^2 - aside^2)
// x > 0 is only a naming convention: (h + pi, -pitch, roll + pi) is the same pose with -x. FiveR::track() selects the
// shoulder.
#pragma once

#include <Eigen/Core>

#include "controller/kinematics/transform.hpp"
#include "controller/robot/arm_geometry.hpp"

namespace armature {

// As in Pose5, for the arm that has the tool point (and not only the flange) in front of it.
struct PlaneAngles {
  double pitch_rad = 0.0;
  double roll_rad = 0.0;
};

// The flange's rotation in coordinates of the arm's plane: base_R_flange at a heading of 0.
[[nodiscard]] Eigen::Matrix3d rotation_in_plane(const PlaneAngles& angles) noexcept;

struct HeldTool {
  Transform base_T_tool{};  // its position is exactly the requested tool point, bit for bit
  // > 0: the tool point is closer to axis 1 than `aside`, by this much. No arm can reach it, and base_T_tool is not
  // valid.
  double missing_mm = 0.0;
};

// The tool with these angles at this point. On axis 1 (with aside = 0) the heading is undefined, and 0 is used. Close
// to axis 1 the heading changes fast.
[[nodiscard]] HeldTool hold_tool(const PlaneAngles& angles, const Eigen::Vector3d& tool_point_mm,
                                 const Transform& flange_T_tool) noexcept;

// Turns a tool orientation that is almost in the arm's plane into it; the tool point stays. A pose that is in the plane
// changes by rounding only.
[[nodiscard]] HeldTool into_plane(const Transform& base_T_tool, const Transform& flange_T_tool) noexcept;

class ArmPlane {
 public:
  // A tool whose approach is within this angle of vertical, up or down, counts as upright (0.01 deg: more than the
  // resolution of encoders).
  static constexpr double kUpright_rad = 1.745e-4;
  // A rotation error up to this is rounding and counts as 0.
  static constexpr double kNoResidual_rad = 1e-9;

  ArmPlane(const ArmGeometry& arm, const Transform& flange_T_tool) noexcept;

  // True when the arm has such a plane: family kFiveR. Otherwise only kept() has a meaning.
  [[nodiscard]] bool exists() const noexcept { return arm_.family == ArmFamily::kFiveR; }
  [[nodiscard]] const Transform& flange_T_tool() const noexcept { return flange_T_tool_; }

  // The largest rotation by which an orientation may be changed into one that the arm can hold. It is always less than
  // a quarter turn, where every pitch would be equally near.
  [[nodiscard]] double max_residual_rad() const noexcept;

  // +1: the approach points up, -1: down, both within kUpright_rad; 0: neither.
  [[nodiscard]] int upright(const Transform& base_T_tool) const noexcept;
  // Sine of the approach's angle to the vertical.
  [[nodiscard]] double tilt(const Transform& base_T_tool) const noexcept;

  // Heading of the plane that contains the tool, in one of its two directions. Requires a pose that the arm can hold.
  [[nodiscard]] double heading_rad(const Transform& base_T_tool) const noexcept;

  struct Nearest {
    PlaneAngles angles{};       // in [-pi, pi]
    double residual_rad = 0.0;  // rotation from the requested pose to hold_tool() with these angles at its tool point
  };
  // Exact for a pose that the arm can hold. Otherwise the flange's orientation is turned into the flange's plane by the
  // smallest angle. For a tool with an offset, following the tool point then turns it once more, by about residual *
  // offset / distance from axis 1. `residual_rad` contains both.
  [[nodiscard]] Nearest nearest(const Transform& base_T_tool) const noexcept;

  // True when a straight line to `to_mm` stays in the present plane of the arm (to 1e-12 of its length) and leads to
  // axis 1 or across it. Requires a pose that the arm can hold.
  [[nodiscard]] bool passes_over_axis_1(const Transform& base_T_tool, const Eigen::Vector3d& to_mm) const noexcept;

  // The orientation of a tool that is moved to another point and "keeps its orientation". It is constant in space where
  // the arm can hold that: on six-axis arms, for an upright tool, and along a `straight` line across axis 1. Otherwise
  // pitch and roll are constant. Not valid where no arm can hold them, see HeldTool::missing_mm.
  [[nodiscard]] Eigen::Matrix3d kept(const Transform& base_T_tool, const Eigen::Vector3d& to_mm,
                                     bool straight) const noexcept;

 private:
  ArmGeometry arm_;
  Transform flange_T_tool_;
  Transform tool_T_flange_;
};

}  // namespace armature
