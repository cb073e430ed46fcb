// The posture of the arm as a job states it (RCONF), and the joints of a pose in a posture.
//
// The first six fields. Bit i is field i + 1:
//   0  0: flip, 1: no flip. Flip: axis 4 (R) is from -90 to 90 degrees, whole turns left out
//   1  0: elbow above the line from joint 2 to the wrist, 1: below
//   2  0: the wrist is in front of axis 1 (S), 1: behind
//   3, 4, 5  axis 4 (R), axis 6 (T), axis 1 (S). 0: from -180 (excluded) to 180 degrees, 1: beyond
#pragma once

#include <cstdint>
#include <optional>

#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature::job {

// Of joints. A side that is not determined, because the arm is at its singularity, is 0.
[[nodiscard]] std::uint8_t rconf_of(const Arm& arm, const JointAngles& joints) noexcept;

// The joints of a pose in a posture, and what of them `previous` has decided. They are the same for any other one where
// neither is true.
struct PostureJoints {
  JointAngles joints{};
  bool free_angle = false;     // the arm is at a singularity, and an angle is that of `previous`
  bool several_turns = false;  // a joint reaches the pose with other whole turns, too
};

// The joints within their limits that reach a pose of the flange in a posture. Of several, which differ by whole turns,
// those nearest to `previous`. Nothing: there are none.
[[nodiscard]] std::optional<PostureJoints> joints_of(const RobotModel& robot, const Arm& arm,
                                                     const Transform& base_T_flange, std::uint8_t rconf,
                                                     const JointAngles& previous) noexcept;

}  // namespace armature::job
