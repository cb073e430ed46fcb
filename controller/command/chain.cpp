#include "controller/command/chain.hpp"

namespace armature {

bool Chain::open() const noexcept {
  return count_ == 0 || (last_blend_mm_ > 0.0 && count_ < requests_.size());
}

void Chain::restart(const Transform& base_T_tool) noexcept {
  count_ = 0;
  end_ = base_T_tool;
}

void Chain::add(const CartesianMove& move, const UserFrames& base_T_user, const ArmPlane& plane) noexcept {
  if (count_ > 0) requests_[count_ - 1].blend_mm = last_blend_mm_;
  SegmentRequest& request = requests_[count_++];
  request = {.kind = move.kind,
             .via_mm = base_T_frame(move.target.frame, base_T_user, end_) * move.via_mm,
             .target = resolve(move.target, base_T_user, end_, plane, move.kind == SegmentRequest::Kind::kLine),
             .keeps_orientation = !move.target.rotation,
             .limits = move.limits,
             .profile = move.profile,
             .configuration = move.target.configuration,
             .tag = move.tag};
  last_blend_mm_ = move.blend_mm;
  // A circle ends at its start point, whatever the orientation does.
  const bool circle = move.kind == SegmentRequest::Kind::kCircle;
  if (circle && !move.target.rotation) request.target.rotation = end_.rotation;
  end_.rotation = request.target.rotation;
  if (!circle) end_.position_mm = request.target.position_mm;
}

}  // namespace armature
