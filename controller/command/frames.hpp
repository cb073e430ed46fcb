// The frames in which poses are given, and what a pose in one of them means in the base.
#pragma once

#include <array>
#include <optional>

#include "controller/command/command.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/trajectory/path/arm_plane.hpp"

namespace armature {

// User frame i + 1 of FrameId is element i; nothing where there is none.
using UserFrames = std::array<std::optional<Transform>, kUserFrames>;

// The base, the tool, or a user frame that is defined.
[[nodiscard]] bool is_known(FrameId frame, const UserFrames& base_T_user) noexcept;

// base_T_frame of a known frame, for a move that begins with the tool at `base_T_tool`.
[[nodiscard]] Transform base_T_frame(FrameId frame, const UserFrames& base_T_user,
                                     const Transform& base_T_tool) noexcept;

// base_T_tool of the pose, in a known frame, for a move that begins with the tool at `base_T_tool`: when the pose has
// no orientation, that of the tool is kept, as ArmPlane::kept() says for a `straight` way or any other. A rotation that
// was given with a few decimals is made orthonormal, so that relative moves do not add up its error.
[[nodiscard]] Transform resolve(const FramedPose& pose, const UserFrames& base_T_user, const Transform& base_T_tool,
                                const ArmPlane& plane, bool straight) noexcept;

}  // namespace armature
