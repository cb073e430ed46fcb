// The fields of the events.
#pragma once

#include "controller/event/event.hpp"
#include "controller/mailbox/event_blocks.hpp"
#include "controller/mailbox/fields_of.hpp"

namespace armature::mailbox {

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
    copy(block.on_conveyor, move.on_conveyor);
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
    copy(block.angle, refusal.path.angle_rad);
    copy(block.limit, refusal.path.limit_rad);
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

template <>
struct FieldsOf<PartFollowed> {
  using Block = PartFollowedBlock;
  static constexpr u32 kKind = 11;
  static void transfer(auto copy, auto& block, auto& part) noexcept {
    copy(block.tag, part.tag);
    copy(block.part, part.part);
    copy(block.tick, part.tick);
    copy(block.phase, part.phase);
    copy(block.end, part.end);
    copy(block.axis, part.axis);
    copy(block.displacement, part.displacement_mm);
    copy(block.deviation, part.deviation_mm);
  }
};

template <>
struct FieldsOf<HomingStarted> {
  using Block = HomingStartedBlock;
  static constexpr u32 kKind = 12;
  static void transfer(auto copy, auto& block, auto& homing) noexcept {
    copy(block.tag, homing.tag);
    copy(block.axis, homing.axis);
    copy(block.tick, homing.tick);
  }
};

template <>
struct FieldsOf<HomingEnded> {
  using Block = HomingEndedBlock;
  static constexpr u32 kKind = 13;
  static void transfer(auto copy, auto& block, auto& homing) noexcept {
    copy(block.tag, homing.tag);
    copy(block.axis, homing.axis);
    copy(block.how, homing.how);
    copy(block.met, homing.met);
    copy(block.tick, homing.tick);
    copy(block.taken, homing.taken);
    copy(block.edge_to_index, homing.edge_to_index);
    copy(block.shift, homing.shift);
  }
};

template <>
struct FieldsOf<ProgramNoted> {
  using Block = ProgramNotedBlock;
  static constexpr u32 kKind = 14;
  static void transfer(auto copy, auto& block, auto& note) noexcept {
    copy(block.place, note.place);
    copy(block.kind, note.kind);
    copy(block.text_size, note.text_size);
    copy(block.inputs, note.inputs);
    copy(block.text, note.text);
  }
};

}  // namespace armature::mailbox
