// The point and the frame of the poses of `armature fk` and `armature ik`: without them, the flange in the base.
#pragma once

#include <optional>
#include <string>

#include "controller/kinematics/transform.hpp"

namespace armature::cosim {

struct PoseFrames {
  std::optional<Transform> flange_T_tool;  // none: poses are those of the flange
  std::optional<Transform> base_T_user;    // none: poses are in the base of the robot

  // From base_T_flange to the pose of the tool (or the flange) in the user frame (or the base), and back. Without a
  // tool and a frame the pose is returned bit for bit.
  [[nodiscard]] Transform shown(const Transform& base_T_flange) const noexcept;
  [[nodiscard]] Transform flange(const Transform& shown) const noexcept;

  // "flange" or "tool"
  [[nodiscard]] std::string point() const { return flange_T_tool ? "tool" : "flange"; }
  // "its base" or "the user frame"
  [[nodiscard]] std::string frame() const { return base_T_user ? "the user frame" : "its base"; }
};

}  // namespace armature::cosim
