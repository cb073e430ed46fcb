// The frames in which poses are given, and the transformation of such poses to the base frame.
#pragma once

#include <array>
#include <optional>

#include "controller/kinematics/transform.hpp"
#include "controller/message/command.hpp"
#include "controller/trajectory/path/arm_plane.hpp"

namespace armature {

// Element i is user frame FrameId{i + 1}; empty when that frame is not defined. The last element is kConveyorFrame.
using UserFrames = std::array<std::optional<Transform>, kUserFrames + 1>;

// True for the base, the tool, and every defined user frame.
[[nodiscard]] bool is_known(FrameId frame, const UserFrames& base_T_user) noexcept;

// base_T_frame of a known frame, for a move that starts with the tool at `base_T_tool`.
[[nodiscard]] Transform base_T_frame(FrameId frame, const UserFrames& base_T_user,
                                     const Transform& base_T_tool) noexcept;

// base_T_tool of a pose in a known frame, for a move that starts with the tool at `base_T_tool`. A pose without
// orientation keeps that of the tool as ArmPlane::kept() defines it; `straight`: the path is a line. A rotation is made
// orthonormal, so that the rounding of its decimals does not accumulate over relative moves.
[[nodiscard]] Transform resolve(const FramedPose& pose, const UserFrames& base_T_user, const Transform& base_T_tool,
                                const ArmPlane& plane, bool straight) noexcept;

}  // namespace armature
