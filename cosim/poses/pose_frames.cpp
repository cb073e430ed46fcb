#include "cosim/poses/pose_frames.hpp"

namespace armature::cosim {

Transform PoseFrames::shown(const Transform& base_T_flange) const noexcept {
  Transform pose = base_T_flange;
  if (flange_T_tool) pose = pose * *flange_T_tool;
  if (base_T_user) pose = inverse(*base_T_user) * pose;
  return pose;
}

Transform PoseFrames::flange(const Transform& shown) const noexcept {
  Transform pose = shown;
  if (base_T_user) pose = *base_T_user * pose;
  if (flange_T_tool) pose = pose * inverse(*flange_T_tool);
  return pose;
}

}  // namespace armature::cosim
