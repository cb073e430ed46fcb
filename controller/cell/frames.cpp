#include "controller/cell/frames.hpp"

#include <Eigen/Geometry>

namespace armature {
namespace {

Eigen::Matrix3d orthonormal(const Eigen::Matrix3d& rotation) {
  Eigen::Matrix3d result;
  result.col(0) = rotation.col(0).normalized();
  result.col(2) = result.col(0).cross(rotation.col(1)).normalized();
  result.col(1) = result.col(2).cross(result.col(0));
  return result;
}

}  // namespace

bool is_known(FrameId frame, const UserFrames& base_T_user) noexcept {
  if (frame == kBaseFrame || frame == kToolFrame) return true;
  return frame.index <= base_T_user.size() && base_T_user[frame.index - 1u].has_value();
}

Transform base_T_frame(FrameId frame, const UserFrames& base_T_user, const Transform& base_T_tool) noexcept {
  if (frame == kBaseFrame) return {};
  if (frame == kToolFrame) return base_T_tool;
  return *base_T_user[frame.index - 1u];
}

Transform resolve(const FramedPose& pose, const UserFrames& base_T_user, const Transform& base_T_tool,
                  const ArmPlane& plane, bool straight) noexcept {
  const Transform frame = base_T_frame(pose.frame, base_T_user, base_T_tool);
  const Eigen::Vector3d position_mm = frame * pose.position_mm;
  return {.rotation = pose.rotation ? orthonormal(frame.rotation * *pose.rotation)
                                    : plane.kept(base_T_tool, position_mm, straight),
          .position_mm = position_mm};
}

}  // namespace armature
