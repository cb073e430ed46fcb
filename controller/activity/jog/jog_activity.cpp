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

VelocityCommand::Kind kind_of(StopKind how) noexcept {
  switch (how) {
    case StopKind::kHold:
      return VelocityCommand::Kind::kHalt;
    case StopKind::kSoft:
      return VelocityCommand::Kind::kSoftStop;
    case StopKind::kQuick:
      break;
  }
  return VelocityCommand::Kind::kStop;
}

}  // namespace

std::optional<MoveRefused> JogActivity::accept(const Jog& jog) noexcept {
  if (std::optional<MoveRefused> refusal = find_refusal(robot_, frames_, jog)) return refusal;
  if (!owner_.referenced()) return MoveRefused{.reason = Refusal::kNotReferenced};
  if (!owner_.has(ActivityId::kJog) && !owner_.rest()) return MoveRefused{.reason = Refusal::kNotReady};
  next_ = velocity_command(jog, frames_);
  ended_.reset();
  owner_.lend(ActivityId::kJog);
  return std::nullopt;
}

void JogActivity::send() noexcept {
  if (!next_ || !mailbox_.jogs.try_push(*next_)) return;
  ++sent_;
  next_.reset();
}

// Also a jog that a weaker command has ended already, and that still brakes.
void JogActivity::stop(StopKind how) noexcept {
  const VelocityCommand::Kind kind = kind_of(how);
  const bool jogs = owner_.has(ActivityId::kJog);
  if (!jogs && !(ended_ && kind > *ended_)) return;
  next_ = VelocityCommand{.kind = kind};
  ended_ = kind;
  if (jogs) owner_.await_rest();
}

void JogActivity::on_rest() noexcept {
  ended_.reset();
  next_.reset();
}

}  // namespace armature
