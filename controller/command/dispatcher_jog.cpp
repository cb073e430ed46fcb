// Jogs: core 1 checks their commands and sends them on, core 0 executes them.
#include <optional>

#include "controller/cell/frames.hpp"
#include "controller/command/dispatcher.hpp"
#include "controller/command/move_checks.hpp"

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

void Dispatcher::accept(const Jog& jog) noexcept {
  std::optional<MoveRefused> refusal = find_refusal(robot_, frames_, jog);
  if (!refusal && !referenced_) refusal = MoveRefused{.reason = Refusal::kNotReferenced};
  if (!refusal && !jogging_ && !rest()) refusal = MoveRefused{.reason = Refusal::kNotReady};
  if (refusal) {
    refusal->tag = jog.tag;
    return events_.on_event(*refusal);
  }
  next_jog_ = velocity_command(jog, frames_);
  jogging_ = true;
  jog_ended_.reset();
  mode_ = Mode::kAwaitingRest;
}

// Also a jog that a weaker command has ended already, and that still brakes.
void Dispatcher::end_jog(VelocityCommand::Kind how) noexcept {
  if (!jogging_ && !(jog_ended_ && how > *jog_ended_)) return;
  next_jog_ = VelocityCommand{.kind = how};
  jogging_ = false;
  jog_ended_ = how;
}

void Dispatcher::send_jog() noexcept {
  if (!next_jog_ || !mailbox_.jogs.try_push(*next_jog_)) return;
  ++jogs_sent_;
  next_jog_.reset();
}

}  // namespace armature
