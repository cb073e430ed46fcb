// The assignment of fields of a block to members of a value. The kinds are part of the layout: a number is never
// reused.
#pragma once

#include "controller/command/command.hpp"
#include "controller/event/event.hpp"
#include "controller/mailbox/command_blocks.hpp"
#include "controller/mailbox/event_blocks.hpp"
#include "controller/motion/telemetry.hpp"

namespace armature::mailbox {

// `copy` is Encode or Decode of wire.hpp. With Encode the value is const, with Decode the block.
template <class Value>
struct FieldsOf;

// ---- commands

inline void transfer_configuration(auto copy, auto& block, auto& configuration) noexcept {
  copy(block.shoulder, configuration.shoulder);
  copy(block.elbow, configuration.elbow);
  copy(block.wrist, configuration.wrist);
  copy.optional(block.has_turns, block.turns, configuration.turns);
}

inline void transfer_outputs(auto copy, auto& block, auto& outputs) noexcept {
  copy(block.outputs, outputs.count);
  for (std::size_t i = 0; i < PathOutputs::kMax; ++i) {
    auto& output = outputs.list[i];
    copy(block.output_pin[i], output.pin);
    copy(block.output_level[i], output.level);
    copy(block.output_from[i], output.from);
    copy(block.output_unit[i], output.unit);
    copy(block.output_offset[i], output.offset);
  }
}

template <>
struct FieldsOf<JointMove> {
  using Block = JointMoveBlock;
  static constexpr u32 kKind = 1;
  static void transfer(auto copy, auto& block, auto& move) noexcept {
    copy(block.tag, move.tag);
    copy(block.profile, move.profile);
    copy(block.now, move.now);
    copy(block.speed, move.speed);
    copy(block.accel, move.accel);
    copy(block.target, move.target);
    copy(block.blend, move.blend.rad);
    copy(block.blend_share, move.blend.share);
    transfer_outputs(copy, block, move.outputs);
  }
};
template <>
struct FieldsOf<PoseMove> {
  using Block = PoseMoveBlock;
  static constexpr u32 kKind = 2;
  static void transfer(auto copy, auto& block, auto& move) noexcept {
    copy(block.tag, move.tag);
    copy(block.profile, move.profile);
    copy(block.frame, move.target.frame.index);
    copy(block.speed, move.speed);
    copy(block.accel, move.accel);
    copy(block.position, move.target.position_mm);
    copy.optional(block.has_rotation, block.rotation, move.target.rotation);
    transfer_configuration(copy, block, move.target.configuration);
    copy(block.blend, move.blend.rad);
    copy(block.blend_share, move.blend.share);
    transfer_outputs(copy, block, move.outputs);
  }
};
template <>
struct FieldsOf<CartesianMove> {
  using Block = CartesianMoveBlock;
  static constexpr u32 kKind = 3;
  static void transfer(auto copy, auto& block, auto& move) noexcept {
    copy(block.tag, move.tag);
    copy(block.profile, move.profile);
    copy(block.frame, move.target.frame.index);
    copy(block.kind, move.kind);
    copy(block.position, move.target.position_mm);
    copy.optional(block.has_rotation, block.rotation, move.target.rotation);
    copy(block.via, move.via_mm);
    copy(block.speed, move.limits.speed_mm_s);
    copy(block.accel, move.limits.accel_mm_s2);
    copy(block.jerk, move.limits.jerk_mm_s3);
    copy(block.turn_speed, move.limits.turn_speed_rad_s);
    copy(block.turn_accel, move.limits.turn_accel_rad_s2);
    copy(block.turn_jerk, move.limits.turn_jerk_rad_s3);
    copy(block.blend, move.blend_mm);
    copy(block.at_singularity, move.at_singularity);
    copy(block.orientation, move.orientation);
    copy(block.tolerance, move.orientation_tolerance_rad);
    transfer_configuration(copy, block, move.target.configuration);
    copy(block.exact_stop, move.exact_stop);
    copy(block.axis, move.about.axis);
    copy(block.angle, move.about.angle_rad);
    copy(block.advance, move.about.advance_mm);
    copy(block.points, move.through.count);
    copy(block.through, move.through.mm);
    copy(block.joint_accel, move.limits.joint_accel);
    transfer_outputs(copy, block, move.outputs);
  }
};
template <>
struct FieldsOf<SetOutput> {
  using Block = SetOutputBlock;
  static constexpr u32 kKind = 4;
  static void transfer(auto copy, auto& block, auto& output) noexcept {
    copy(block.tag, output.tag);
    copy(block.pin, output.pin);
    copy(block.level, output.level);
  }
};
template <>
struct FieldsOf<WaitInput> {
  using Block = WaitInputBlock;
  static constexpr u32 kKind = 5;
  static void transfer(auto copy, auto& block, auto& wait) noexcept {
    copy(block.tag, wait.tag);
    copy(block.pin, wait.pin);
    copy(block.level, wait.level);
    copy(block.timeout, wait.timeout);
  }
};
// A command without parameters.
template <u32 kNumber>
struct PlainFields {
  using Block = PlainCommandBlock;
  static constexpr u32 kKind = kNumber;
  static void transfer(auto, auto&, auto&) noexcept {}
};
template <>
struct FieldsOf<Hold> : PlainFields<6> {};
template <>
struct FieldsOf<Resume> : PlainFields<7> {};
template <>
struct FieldsOf<SetOverride> {
  using Block = SetOverrideBlock;
  static constexpr u32 kKind = 8;
  static void transfer(auto copy, auto& block, auto& wanted) noexcept {
    copy(block.tag, wanted.tag);
    copy(block.share, wanted.share);
  }
};
template <>
struct FieldsOf<Stop> : PlainFields<9> {};
template <>
struct FieldsOf<ClearFault> {
  using Block = ClearFaultBlock;
  static constexpr u32 kKind = 10;
  static void transfer(auto copy, auto& block, auto& clear) noexcept { copy(block.tag, clear.tag); }
};

template <>
struct FieldsOf<Jog> {
  using Block = JogBlock;
  static constexpr u32 kKind = 11;
  static void transfer(auto copy, auto& block, auto& jog) noexcept {
    copy(block.tag, jog.tag);
    copy(block.kind, jog.kind);
    copy(block.frame, jog.frame.index);
    copy(block.duration, jog.duration);
    copy(block.joints, jog.joint_rad_s);
    copy(block.move, jog.move_mm_s);
    copy(block.turn, jog.turn_rad_s);
    copy(block.profile, jog.profile);
    copy(block.accel_share, jog.accel_share);
    copy(block.accel, jog.tool.accel_mm_s2);
    copy(block.turn_accel, jog.tool.turn_accel_rad_s2);
    copy(block.jerk, jog.tool.jerk_mm_s3);
    copy(block.turn_jerk, jog.tool.turn_jerk_rad_s3);
  }
};

template <>
struct FieldsOf<StreamPoint> {
  using Block = StreamPointBlock;
  static constexpr u32 kKind = 12;
  static void transfer(auto copy, auto& block, auto& point) noexcept {
    copy(block.tag, point.tag);
    copy(block.kind, point.kind);
    copy(block.first, point.first);
    copy(block.last, point.last);
    copy(block.profile, point.profile);
    copy(block.time, point.time);
    copy(block.delay, point.delay);
    copy(block.joints, point.joints);
    copy(block.position, point.position_mm);
    copy(block.rotation, point.rotation);
  }
};

template <>
struct FieldsOf<Dwell> {
  using Block = DwellBlock;
  static constexpr u32 kKind = 13;
  static void transfer(auto copy, auto& block, auto& dwell) noexcept {
    copy(block.tag, dwell.tag);
    copy(block.duration, dwell.duration);
  }
};

// ---- events

template <>
struct FieldsOf<MoveStarted> {
  using Block = MoveStartedBlock;
  static constexpr u32 kKind = 1;
  static void transfer(auto copy, auto& block, auto& move) noexcept {
    copy(block.tag, move.tag);
    copy(block.kind, move.kind);
    copy(block.stretched_for, move.stretched_for);
    copy(block.continues, move.continues);
    copy(block.start_tick, move.start_tick);
    copy(block.duration, move.duration);
    copy(block.peak_speed, move.peak_speed_rad_s);
    copy(block.accel, move.accel_rad_s2);
    copy(block.path_shape, move.path.shape);
    copy(block.path_start, move.path.start_mm);
    copy(block.path_end, move.path.end_mm);
    copy(block.path_center, move.path.center_mm);
    copy(block.path_x, move.path.x);
    copy(block.path_y, move.path.y);
    copy(block.path_length, move.path.length_mm);
    copy(block.path_radius, move.path.radius_mm);
    copy(block.path_angle, move.path.angle_rad);
    copy(block.path_advance, move.path.advance_mm);
    copy(block.path_points, move.through.count);
    copy(block.path_through, move.through.mm);
    copy(block.stretch, move.stretch);
    copy(block.residual, move.residual_rad);
    copy(block.shape, move.shape);
  }
};
template <>
struct FieldsOf<MoveFinished> {
  using Block = MoveFinishedBlock;
  static constexpr u32 kKind = 2;
  static void transfer(auto copy, auto& block, auto& move) noexcept {
    copy(block.tag, move.tag);
    copy(block.how, move.how);
    copy(block.tick, move.tick);
    copy(block.taken, move.taken);
  }
};
template <>
struct FieldsOf<MoveRefused> {
  using Block = MoveRefusedBlock;
  static constexpr u32 kKind = 3;
  static void transfer(auto copy, auto& block, auto& refusal) noexcept {
    copy(block.tag, refusal.tag);
    copy(block.reason, refusal.reason);
    copy(block.axis, refusal.axis);
    copy(block.problem, refusal.path.kind);
    copy(block.segment, refusal.path.segment);
    copy(block.problem_axis, refusal.path.axis);
    copy(block.singular, refusal.path.singular);
    copy(block.configuration, refusal.path.configuration);
    copy(block.at, refusal.path.at);
    copy(block.margin, refusal.path.margin_mm);
    copy(block.residual, refusal.path.residual_rad);
    copy(block.stretch, refusal.path.stretch);
  }
};
template <>
struct FieldsOf<IoDone> {
  using Block = IoDoneBlock;
  static constexpr u32 kKind = 4;
  static void transfer(auto copy, auto& block, auto& done) noexcept {
    copy(block.tag, done.tag);
    copy(block.pin, done.pin);
    copy(block.level, done.level);
  }
};
template <>
struct FieldsOf<Faulted> {
  using Block = FaultedBlock;
  static constexpr u32 kKind = 5;
  static void transfer(auto copy, auto& block, auto& fault) noexcept {
    copy(block.cause, fault.cause);
    copy(block.axis, fault.axis);
    copy(block.tick, fault.tick);
  }
};
template <>
struct FieldsOf<FaultCleared> {
  using Block = FaultClearedBlock;
  static constexpr u32 kKind = 6;
  static void transfer(auto copy, auto& block, auto& cleared) noexcept { copy(block.tick, cleared.tick); }
};

template <>
struct FieldsOf<JogStarted> {
  using Block = JogStartedBlock;
  static constexpr u32 kKind = 7;
  static void transfer(auto copy, auto& block, auto& jog) noexcept {
    copy(block.tag, jog.tag);
    copy(block.tick, jog.tick);
  }
};
template <>
struct FieldsOf<JogEnded> {
  using Block = JogEndedBlock;
  static constexpr u32 kKind = 8;
  static void transfer(auto copy, auto& block, auto& jog) noexcept {
    copy(block.tag, jog.tag);
    copy(block.how, jog.how);
    copy(block.axis, jog.axis);
    copy(block.tick, jog.tick);
    copy(block.taken, jog.taken);
    copy(block.commands, jog.commands);
  }
};
template <>
struct FieldsOf<StreamEnded> {
  using Block = StreamEndedBlock;
  static constexpr u32 kKind = 9;
  static void transfer(auto copy, auto& block, auto& ended) noexcept {
    copy(block.tag, ended.tag);
    copy(block.how, ended.how);
    copy(block.tick, ended.tick);
    copy(block.followed, ended.followed);
    copy(block.deviation, ended.deviation_rad);
  }
};
template <>
struct FieldsOf<OutputSwitched> {
  using Block = OutputSwitchedBlock;
  static constexpr u32 kKind = 10;
  static void transfer(auto copy, auto& block, auto& output) noexcept {
    copy(block.tag, output.tag);
    copy(block.pin, output.pin);
    copy(block.level, output.level);
    copy(block.tick, output.tick);
  }
};

// ---- telemetry: all fields of the block except `published`

template <>
struct FieldsOf<Telemetry> {
  using Block = TelemetryBlock;
  static void transfer(auto copy, auto& block, auto& telemetry) noexcept {
    copy(block.underruns, telemetry.underruns);
    copy(block.tick, telemetry.tick);
    copy(block.state, telemetry.state);
    copy(block.fault, telemetry.fault);
    copy(block.fault_axis, telemetry.fault_axis);
    copy(block.sequence, telemetry.sequence);
    copy(block.rate, telemetry.rate);
    copy(block.reference, telemetry.reference);
    copy(block.reference_pulses, telemetry.reference_pulses);
    copy(block.correction, telemetry.correction);
    copy(block.commanded, telemetry.commanded);
    copy(block.encoder, telemetry.encoder);
    copy(block.actual, telemetry.actual);
  }
};

}  // namespace armature::mailbox
