// The pose of an arm with five joints, in the five numbers that determine it.
#pragma once

namespace armature {

// Tool point and tool direction of a kFiveR arm, see FiveR. Its approach vector lies in the vertical plane through
// axis 1 and the tool point; `pitch` turns it inside that plane, `roll` turns the tool about it. Both are defined for
// an arm that faces the tool point (shoulder +1), and then are sums of joint angles:
//   pitch = theta_2 + theta_3 + theta_4    0: approach straight down (-z), -pi/2: outwards, pi/2: towards axis 1
//   roll  = theta_5                        0: the tool's y axis is horizontal, to the right when facing outwards
struct Pose5 {
  double x_mm = 0.0, y_mm = 0.0, z_mm = 0.0;  // tool point in the base frame
  double pitch_rad = 0.0;
  double roll_rad = 0.0;

  // Direction of the plane: theta_1 of the arm that faces along it. The tool point determines it. This value is read
  // only where the tool point is on axis 1, to rounding, and does not determine it.
  double heading_rad = 0.0;
};

// The projection of a pose with six degrees of freedom.
struct NearestPose5 {
  Pose5 pose{};               // angles in [-pi, pi]
  double residual_rad = 0.0;  // rotation from the requested pose to the nearest Pose5 at its tool point, 0 .. pi/2
};

}  // namespace armature
