#include "controller/activity/jog/jog_activity.hpp"

#include "controller/activity/move_checks.hpp"

namespace armature {
namespace {

// The velocity that a valid jog commands, with its time-out.
VelocityCommand velocity_command(const Jog& jog, const UserFrames& base_T_user) noexcept {
  VelocityCommand command{.joint_rad_s = jog.joint_rad_s, .time_out = jog.duration, .tag = jog.tag};
  command.manner = {.profile = jog.profile, .accel_share = jog.accel_share, .tool = jog.tool};
  if (jog.profile != ProfileKind::kSCurve)
    command.manner->tool.jerk_mm_s3 = command.manner->tool.turn_jerk_rad_s3 = 0.0;
  if (jog.kind == Jog::Kind::kJoints) return command;
  const bool in_tool = jog.frame == kToolFrame;
  const Eigen::Matrix3d rotation = base_T_frame(in_tool ? kBaseFrame : jog.frame, base_T_user, {}).rotation;
  command.kind = VelocityCommand::Kind::kTool;
  command.tool = {.frame = in_tool ? ToolTwist::Frame::kTool : ToolTwist::Frame::kBase,
                  .move_mm_s = rotation * jog.move_mm_s,
                  .turn_rad_s = rotation * jog.turn_rad_s};
  return command;
}

}  // namespace

std::optional<MoveRefused> JogActivity::accept(const Jog& jog) noexcept {
  if (std::optional<MoveRefused> refusal = find_refusal(context_.robot, context_.frames, jog)) return refusal;
  if (!context_.owner.referenced()) return refused(Refusal::kNotReferenced);
  if (!context_.owner.has(ActivityId::kJog) && !context_.owner.rest()) return refused(Refusal::kNotReady);
  next_ = velocity_command(jog, context_.frames);
  context_.owner.lend(ActivityId::kJog);
  return std::nullopt;
}

void JogActivity::send() noexcept {
  if (!next_ || !context_.channel.has_unread_at_most(Channel::kJogs - 1)) return;
  context_.owner.begin(ActivityId::kJog, *next_);
  next_.reset();
}

}  // namespace armature
