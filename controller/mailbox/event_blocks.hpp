// The events of controller/event/event.hpp and the telemetry as blocks. Angles in rad, lengths in mm, times in ticks.
#pragma once

#include "controller/mailbox/block.hpp"

namespace armature::mailbox {

#define ARMATURE_MOVE_STARTED(F)                                       \
  F(0, u32, tag, "of the command")                                     \
  F(4, u8, kind, "MoveKind")                                           \
  F(5, u8, stretched_for, "joint 1..6, or 0")                          \
  F(6, u8, continues, "flag: blended with the previous move")          \
  F(7, u8, path_shape, "PositionPath::Shape")                          \
  F(8, i64, start_tick, "of the first step")                           \
  F(16, i64, duration, "planned, ticks")                               \
  F(24, f64x6, peak_speed, "of each joint, rad/s")                     \
  F(72, f64x6, accel, "of each joint, rad/s^2")                        \
  F(120, f64x3, path_start, "mm")                                      \
  F(144, f64x3, path_end, "mm")                                        \
  F(168, f64x3, path_center, "of an arc, mm")                          \
  F(192, f64x3, path_x, "of an arc, unit vector")                      \
  F(216, f64x3, path_y, "of an arc, unit vector")                      \
  F(240, f64, path_length, "mm")                                       \
  F(248, f64, path_radius, "of an arc, mm")                            \
  F(256, f64, path_angle, "of an arc, rad")                            \
  F(264, f64, path_advance, "of a helix, mm")                          \
  F(272, f64, stretch, "factor of the slow-down for the joint limits") \
  F(280, f64, residual, "orientation error, rad")                      \
  F(288, u8x6, shape, "ProfileShape of each joint")                    \
  F(294, u8, path_points, "of a spline, between both ends: 0..15")     \
  F(295, u8, on_conveyor, "flag: the path moves with the belt")        \
  F(296, f64x3x15, path_through, "these points, mm")
ARMATURE_BLOCK(MoveStartedBlock, ARMATURE_MOVE_STARTED);

#define ARMATURE_MOVE_FINISHED(F)                            \
  F(0, u32, tag, "of the command")                           \
  F(4, u8, how, "MoveFinished::How")                         \
  F(5, u8x3, reserved, "0")                                  \
  F(8, i64, tick, "of the last step, the stop or the fault") \
  F(16, i64, taken, "ticks")
ARMATURE_BLOCK(MoveFinishedBlock, ARMATURE_MOVE_FINISHED);

#define ARMATURE_MOVE_REFUSED(F)                             \
  F(0, u32, tag, "of the command")                           \
  F(4, u8, reason, "Refusal")                                \
  F(5, u8, axis, "1..6, or 0")                               \
  F(6, u8, problem, "PathProblem::Kind")                     \
  F(7, u8, segment, "of the chain, from 0")                  \
  F(8, u8, problem_axis, "1..6, or 0")                       \
  F(9, u8, singular, "mask of Singularity")                  \
  F(10, u8, configuration, "mask of ConfigurationPart")      \
  F(11, u8x5, reserved, "0")                                 \
  F(16, f64, at, "position as a share of the segment, 0..1") \
  F(24, f64, margin, "distance beyond the reach, mm")        \
  F(32, f64, residual, "orientation error, rad")             \
  F(40, f64, stretch, "factor of the time needed")           \
  F(48, f64, angle, "of a joint outside its limits, rad")    \
  F(56, f64, limit, "that it would pass, rad")
ARMATURE_BLOCK(MoveRefusedBlock, ARMATURE_MOVE_REFUSED);

#define ARMATURE_IO_DONE(F)        \
  F(0, u32, tag, "of the command") \
  F(4, u8, pin, "1..16")           \
  F(5, u8, level, "flag")          \
  F(6, u8x2, reserved, "0")
ARMATURE_BLOCK(IoDoneBlock, ARMATURE_IO_DONE);

#define ARMATURE_OUTPUT_SWITCHED(F) \
  F(0, u32, tag, "of the move")     \
  F(4, u8, pin, "1..16")            \
  F(5, u8, level, "flag")           \
  F(6, u8x2, reserved, "0")         \
  F(8, i64, tick, "in which it was written")
ARMATURE_BLOCK(OutputSwitchedBlock, ARMATURE_OUTPUT_SWITCHED);

#define ARMATURE_FAULTED(F)     \
  F(0, u8, cause, "FaultCause") \
  F(1, u8, axis, "1..6, or 0")  \
  F(2, u8x6, reserved, "0")     \
  F(8, i64, tick, "-1: before the first tick")
ARMATURE_BLOCK(FaultedBlock, ARMATURE_FAULTED);

#define ARMATURE_FAULT_CLEARED(F) F(0, i64, tick, "of leaving Fault")
ARMATURE_BLOCK(FaultClearedBlock, ARMATURE_FAULT_CLEARED);

#define ARMATURE_JOG_STARTED(F)    \
  F(0, u32, tag, "of the command") \
  F(4, u32, reserved, "0")         \
  F(8, i64, tick, "of the first step")
ARMATURE_BLOCK(JogStartedBlock, ARMATURE_JOG_STARTED);

#define ARMATURE_JOG_ENDED(F)                      \
  F(0, u32, tag, "of the command that started it") \
  F(4, u8, how, "JogEnd")                          \
  F(5, u8, axis, "1..6, or 0")                     \
  F(6, u8x2, reserved, "0")                        \
  F(8, i64, tick, "of the last step or the fault") \
  F(16, i64, taken, "ticks")                       \
  F(24, u32, commands, "that core 0 received")     \
  F(28, u32, reserved2, "0")
ARMATURE_BLOCK(JogEndedBlock, ARMATURE_JOG_ENDED);

#define ARMATURE_STREAM_ENDED(F)    \
  F(0, u32, tag, "of the stream")   \
  F(4, u8, how, "StreamEnded::How") \
  F(5, u8x3, reserved, "0")         \
  F(8, i64, tick, "of the end")     \
  F(16, i64, followed, "ticks")     \
  F(24, f64x6, deviation, "largest, rad")
ARMATURE_BLOCK(StreamEndedBlock, ARMATURE_STREAM_ENDED);

#define ARMATURE_PART_FOLLOWED(F)               \
  F(0, u32, tag, "of the first command")        \
  F(4, u32, part, "number of the part, from 0") \
  F(8, i64, tick, "of the event")               \
  F(16, u8, phase, "PartPhase")                 \
  F(17, u8, end, "PartEnd")                     \
  F(18, u8, axis, "1..6, or 0")                 \
  F(19, u8x5, reserved, "0")                    \
  F(24, f64, displacement, "of the part, mm")   \
  F(32, f64, deviation, "largest one of the set-points, mm")
ARMATURE_BLOCK(PartFollowedBlock, ARMATURE_PART_FOLLOWED);

#define ARMATURE_HOMING_STARTED(F) \
  F(0, u32, tag, "of the command") \
  F(4, u8, axis, "1..6")           \
  F(5, u8x3, reserved, "0")        \
  F(8, i64, tick, "of the first step")
ARMATURE_BLOCK(HomingStartedBlock, ARMATURE_HOMING_STARTED);

#define ARMATURE_HOMING_ENDED(F)                    \
  F(0, u32, tag, "of the command")                  \
  F(4, u8, axis, "1..6")                            \
  F(5, u8, how, "HomingEnd")                        \
  F(6, u8, met, "HomingSwitch")                     \
  F(7, u8, reserved, "0")                           \
  F(8, i64, tick, "in which the axis stands")       \
  F(16, i64, taken, "ticks")                        \
  F(24, i64, edge_to_index, "counts, without sign") \
  F(32, i64, shift, "added to the counts of the encoder")
ARMATURE_BLOCK(HomingEndedBlock, ARMATURE_HOMING_ENDED);

#define ARMATURE_PROGRAM_NOTED(F)                               \
  F(0, u32, place, "in the program, as its interpreter has it") \
  F(4, u8, kind, "ProgramNoted::Kind")                          \
  F(5, u8, text_size, "0..64")                                  \
  F(6, u16, inputs, "mask, bit 0 for pin 1")                    \
  F(8, u8x64, text, "its characters")
ARMATURE_BLOCK(ProgramNotedBlock, ARMATURE_PROGRAM_NOTED);

using EventBody = std::array<u8, sizeof(MoveStartedBlock)>;
#define ARMATURE_EVENT(F)                          \
  F(0, u32, kind, "kind of the block in the body") \
  F(4, u32, reserved, "0")                         \
  F(8, EventBody, body, "the block, padded with 0")
ARMATURE_BLOCK(EventBlock, ARMATURE_EVENT);

#define ARMATURE_TELEMETRY(F)                                               \
  F(0, u32, published, "odd while the block is being written; +2 per tick") \
  F(4, u32, underruns, "total count")                                       \
  F(8, i64, tick, "-1: before the first tick")                              \
  F(16, u8, state, "MotionState")                                           \
  F(17, u8, fault, "FaultCause")                                            \
  F(18, u8, fault_axis, "1..6, or 0")                                       \
  F(19, u8, referenced, "mask of axes whose joint angles are known")        \
  F(20, u16, sequence, "of the commit of this tick")                        \
  F(22, u8x2, reserved, "0")                                                \
  F(24, f64, rate, "path time per time, 0..1")                              \
  F(32, f64x6, reference, "set-point, rad")                                 \
  F(80, i64x6, reference_pulses, "set-point, pulses")                       \
  F(128, i64x6, correction, "of the feedback, pulses")                      \
  F(176, i64x6, commanded, "total, pulses")                                 \
  F(224, i64x6, encoder, "counts")                                          \
  F(272, f64x6, actual, "encoder, rad")
ARMATURE_BLOCK(TelemetryBlock, ARMATURE_TELEMETRY);

}  // namespace armature::mailbox
