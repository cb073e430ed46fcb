// The fields of the commands.
#pragma once

#include <cstddef>

#include "controller/command/command.hpp"
#include "controller/mailbox/command_blocks.hpp"
#include "controller/mailbox/fields_of.hpp"

namespace armature::mailbox {

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
struct FieldsOf<Stop> {
  using Block = StopBlock;
  static constexpr u32 kKind = 9;
  static void transfer(auto copy, auto& block, auto& stop) noexcept { copy(block.kind, stop.kind); }
};
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

template <>
struct FieldsOf<ConveyorPart> {
  using Block = ConveyorPartBlock;
  static constexpr u32 kKind = 14;
  static void transfer(auto copy, auto& block, auto& part) noexcept { copy(block.counts, part.counts); }
};

template <>
struct FieldsOf<Home> {
  using Block = HomeBlock;
  static constexpr u32 kKind = 15;
  static void transfer(auto copy, auto& block, auto& home) noexcept {
    copy(block.tag, home.tag);
    copy(block.axes, home.axes);
  }
};
template <>
struct FieldsOf<SwitchOff> {
  using Block = SwitchOffBlock;
  static constexpr u32 kKind = 16;
  static void transfer(auto copy, auto& block, auto& off) noexcept { copy(block.tag, off.tag); }
};

}  // namespace armature::mailbox
