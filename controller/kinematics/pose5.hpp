// The pose of an arm with five joints, in the five numbers that it can choose.
#pragma once

namespace armature {

// Tool point and tool direction of a kFiveR arm, see FiveR. Its approach vector lies in the vertical plane through
// axis 1 and the tool point; `pitch` turns it inside that plane, `roll` turns the tool about it. Both are meant for an
// arm that looks towards the tool point (shoulder +1), and then are sums of joint angles:
//   pitch = theta_2 + theta_3 + theta_4    0: approach straight down (-z), -pi/2: outwards, pi/2: towards axis 1
//   roll  = theta_5                        0: the tool's y axis is horizontal, to the right of someone looking outwards
struct Pose5 {
  double x_mm = 0.0, y_mm = 0.0, z_mm = 0.0;  // tool point in the base frame
  double pitch_rad = 0.0;
  double roll_rad = 0.0;

  // Direction of the plane, the theta_1 of the arm that looks along it. The tool point gives it; this is only read
  // where the tool point is on axis 1 and leaves it open, or as near to it as rounding.
  double heading_rad = 0.0;
};

// What is left of a pose with six degrees of freedom.
struct NearestPose5 {
  Pose5 pose{};               // angles in [-pi, pi]
  double residual_rad = 0.0;  // rotation from the pose asked for to the nearest Pose5 at its tool point, 0 .. pi/2
};

}  // namespace armature
