// The vertical plane of a five-axis arm (five_r.hpp) and its tool: which orientations can be held at a tool point, in
// the two angles that are free there.
//
// The flange and its approach lie in one vertical plane through axis 1. A tool that is not on the approach may leave
// the plane by `aside`, which depends on roll and pitch alone. The plane's heading h then follows from the tool point
// p, and the tool point is met exactly whatever the tool:
//   Rz(h) (x, aside) = (p_x, p_y),  x = +sqrt(p_x^2 + p_y^2 - aside^2)
// x > 0 is a choice of names only: (h + pi, -pitch, roll + pi) is the same pose with -x. Which way round the arm
// reaches it is up to FiveR::track().
#pragma once

#include <Eigen/Core>

#include "controller/kinematics/transform.hpp"
#include "controller/robot/arm_geometry.hpp"

namespace armature {

// As in Pose5, for the arm that has the tool point (and not only the flange) before it.
struct PlaneAngles {
  double pitch_rad = 0.0;
  double roll_rad = 0.0;
};

// The flange's rotation seen in the arm's plane: base_R_flange at a heading of 0.
[[nodiscard]] Eigen::Matrix3d rotation_in_plane(const PlaneAngles& angles) noexcept;

struct HeldTool {
  Transform base_T_tool{};  // its position is the tool point that was asked for, bit for bit
  // > 0: the tool point is nearer to axis 1 than the tool is aside of the plane, by this much. No arm can do it, and
  // base_T_tool is of no use.
  double missing_mm = 0.0;
};

// The tool with these angles at this point. On axis 1 (and aside of 0) the heading is open; it is 0 there, and turns
// the faster the nearer the point comes.
[[nodiscard]] HeldTool hold_tool(const PlaneAngles& angles, const Eigen::Vector3d& tool_point_mm,
                                 const Transform& flange_T_tool) noexcept;

// A tool orientation that is almost in the arm's plane, brought into it; the tool point stays. Changes nothing, to
// rounding, when the pose is in the plane already.
[[nodiscard]] HeldTool into_plane(const Transform& base_T_tool, const Transform& flange_T_tool) noexcept;

class ArmPlane {
 public:
  // A hand within this of vertical, up or down, counts as upright (0.01 deg: more than encoder counts make).
  static constexpr double kUpright_rad = 1.745e-4;
  // A rotation missed by no more than this is met: rounding.
  static constexpr double kNoResidual_rad = 1e-9;

  ArmPlane(const ArmGeometry& arm, const Transform& flange_T_tool) noexcept;

  // Whether the arm has such a plane at all: of the family kFiveR. Otherwise only kept() means anything.
  [[nodiscard]] bool exists() const noexcept { return arm_.family == ArmFamily::kFiveR; }
  [[nodiscard]] const Transform& flange_T_tool() const noexcept { return flange_T_tool_; }

  // The largest rotation by which an orientation may be changed into one that can be held; always less than a quarter
  // turn, where no pitch is nearer than another.
  [[nodiscard]] double max_residual_rad() const noexcept;

  // +1: the approach points up, -1: down, both within kUpright_rad; 0: neither.
  [[nodiscard]] int upright(const Transform& base_T_tool) const noexcept;
  // Sine of the approach's angle to the vertical.
  [[nodiscard]] double tilt(const Transform& base_T_tool) const noexcept;

  // Heading of the plane that holds the tool, in one of its two directions. Of a pose that can be held.
  [[nodiscard]] double heading_rad(const Transform& base_T_tool) const noexcept;

  struct Nearest {
    PlaneAngles angles{};       // in [-pi, pi]
    double residual_rad = 0.0;  // rotation from the pose asked for to hold_tool() of these at its tool point
  };
  // Exact for a pose that can be held. Otherwise the flange's orientation is turned into the flange's plane by the
  // smallest angle; where the tool has an offset, following the tool point then turns it once more, by about
  // residual * offset / distance from axis 1. `residual_rad` has both.
  [[nodiscard]] Nearest nearest(const Transform& base_T_tool) const noexcept;

  // A straight line to `to_mm` stays in the plane that the arm is in (to 1e-12 of its length) and leads to axis 1 or
  // over it. Of a pose that can be held.
  [[nodiscard]] bool passes_over_axis_1(const Transform& base_T_tool, const Eigen::Vector3d& to_mm) const noexcept;

  // The orientation of a tool that is moved to another point and "keeps its orientation": in space where that can be
  // held, which is on six-axis arms, for an upright hand and along a `straight` line over axis 1; otherwise with pitch
  // and roll as they are. Where no arm holds these, see HeldTool::missing_mm, it is of no use.
  [[nodiscard]] Eigen::Matrix3d kept(const Transform& base_T_tool, const Eigen::Vector3d& to_mm,
                                     bool straight) const noexcept;

 private:
  ArmGeometry arm_;
  Transform flange_T_tool_;
  Transform tool_T_flange_;
};

}  // namespace armature
