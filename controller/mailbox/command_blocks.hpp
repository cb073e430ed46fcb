// The commands of controller/command/command.hpp as blocks. Angles in rad, lengths in mm, times in ticks.
#pragma once

#include <algorithm>

#include "controller/mailbox/block.hpp"

namespace armature::mailbox {

#define ARMATURE_JOINT_MOVE(F)                          \
  F(0, u32, tag, "of the command")                      \
  F(4, u8, profile, "ProfileKind")                      \
  F(5, u8, now, "flag: replaces the motion")            \
  F(6, u8x2, reserved, "0")                             \
  F(8, f64, speed, "scale of the speed limits")         \
  F(16, f64x6, target, "joint angles, rad")             \
  F(64, f64, blend, "deviation, rad")                   \
  F(72, f64, blend_share, "of half the way")            \
  F(80, f64, accel, "scale of the acceleration limits") \
  F(88, u8x4, output_pin, "of outputs, 1..16")          \
  F(92, u8x4, output_level, "flags")                    \
  F(96, u8x4, output_from, "PathOutput::From")          \
  F(100, u8x4, output_unit, "PathOutput::Unit")         \
  F(104, f64x4, output_offset, "mm or s")               \
  F(136, u8, outputs, "number of outputs")              \
  F(137, u8x7, reserved2, "0")
ARMATURE_BLOCK(JointMoveBlock, ARMATURE_JOINT_MOVE);

#define ARMATURE_POSE_MOVE(F)                            \
  F(0, u32, tag, "of the command")                       \
  F(4, u8, profile, "ProfileKind")                       \
  F(5, u8, frame, "FrameId")                             \
  F(6, u8, has_rotation, "flag")                         \
  F(7, u8, reserved, "0")                                \
  F(8, f64, speed, "scale of the speed limits")          \
  F(16, f64x3, position, "of the target, mm")            \
  F(40, f64x9, rotation, "of the target")                \
  F(112, u8, shoulder, "ShoulderSide")                   \
  F(113, u8, elbow, "ElbowSide")                         \
  F(114, u8, wrist, "WristSide")                         \
  F(115, u8, has_turns, "flag")                          \
  F(116, u8x6, turns, "of each joint, signed")           \
  F(122, u8x6, reserved2, "0")                           \
  F(128, f64, blend, "deviation, rad")                   \
  F(136, f64, blend_share, "of half the way")            \
  F(144, f64, accel, "scale of the acceleration limits") \
  F(152, u8x4, output_pin, "of outputs, 1..16")          \
  F(156, u8x4, output_level, "flags")                    \
  F(160, u8x4, output_from, "PathOutput::From")          \
  F(164, u8x4, output_unit, "PathOutput::Unit")          \
  F(168, f64x4, output_offset, "mm or s")                \
  F(200, u8, outputs, "number of outputs")               \
  F(201, u8x7, reserved3, "0")
ARMATURE_BLOCK(PoseMoveBlock, ARMATURE_POSE_MOVE);

#define ARMATURE_CARTESIAN_MOVE(F)                                        \
  F(0, u32, tag, "of the command")                                        \
  F(4, u8, profile, "ProfileKind")                                        \
  F(5, u8, frame, "FrameId")                                              \
  F(6, u8, has_rotation, "flag")                                          \
  F(7, u8, kind, "SegmentRequest::Kind")                                  \
  F(8, f64x3, position, "of the target, mm")                              \
  F(32, f64x9, rotation, "of the target")                                 \
  F(104, f64x3, via, "of an arc or a circle, or a point of the axis, mm") \
  F(128, f64, speed, "mm/s")                                              \
  F(136, f64, accel, "mm/s^2")                                            \
  F(144, f64, jerk, "mm/s^3")                                             \
  F(152, f64, turn_speed, "rad/s")                                        \
  F(160, f64, turn_accel, "rad/s^2")                                      \
  F(168, f64, turn_jerk, "rad/s^3")                                       \
  F(176, f64, blend, "largest deviation, mm")                             \
  F(184, u8, shoulder, "ShoulderSide")                                    \
  F(185, u8, elbow, "ElbowSide")                                          \
  F(186, u8, wrist, "WristSide")                                          \
  F(187, u8, has_turns, "flag")                                           \
  F(188, u8x6, turns, "of each joint, signed")                            \
  F(194, u8, exact_stop, "flag")                                          \
  F(195, u8, points, "of a spline, between its start and its end: 0..15") \
  F(196, u8, outputs, "number of outputs on the path")                    \
  F(197, u8, at_singularity, "AtSingularity")                             \
  F(198, u8, orientation, "Orientation")                                  \
  F(199, u8, reserved, "0")                                               \
  F(200, f64x3, axis, "of an arc about an axis")                          \
  F(224, f64, angle, "about the axis, rad")                               \
  F(232, f64, advance, "along the axis, mm")                              \
  F(240, f64x3x15, through, "these points, mm")                           \
  F(600, f64, joint_accel, "share of the joints' acceleration limits")    \
  F(608, u8x4, output_pin, "of these outputs, 1..16")                     \
  F(612, u8x4, output_level, "flags")                                     \
  F(616, u8x4, output_from, "PathOutput::From")                           \
  F(620, u8x4, output_unit, "PathOutput::Unit")                           \
  F(624, f64x4, output_offset, "mm or s")                                 \
  F(656, f64, tolerance, "of the orientation, rad")
ARMATURE_BLOCK(CartesianMoveBlock, ARMATURE_CARTESIAN_MOVE);

#define ARMATURE_DWELL(F)          \
  F(0, u32, tag, "of the command") \
  F(4, u32, reserved, "0")         \
  F(8, i64, duration, "ticks")
ARMATURE_BLOCK(DwellBlock, ARMATURE_DWELL);

#define ARMATURE_SET_OUTPUT(F)     \
  F(0, u32, tag, "of the command") \
  F(4, u8, pin, "1..16")           \
  F(5, u8, level, "flag")          \
  F(6, u8x2, reserved, "0")
ARMATURE_BLOCK(SetOutputBlock, ARMATURE_SET_OUTPUT);

#define ARMATURE_WAIT_INPUT(F)     \
  F(0, u32, tag, "of the command") \
  F(4, u8, pin, "1..16")           \
  F(5, u8, level, "flag")          \
  F(6, u8x2, reserved, "0")        \
  F(8, i64, timeout, "ticks; 0: no time-out")
ARMATURE_BLOCK(WaitInputBlock, ARMATURE_WAIT_INPUT);

#define ARMATURE_SET_OVERRIDE(F)   \
  F(0, u32, tag, "of the command") \
  F(4, u32, reserved, "0")         \
  F(8, f64, share, "of the planned speed")
ARMATURE_BLOCK(SetOverrideBlock, ARMATURE_SET_OVERRIDE);

#define ARMATURE_JOG(F)                                    \
  F(0, u32, tag, "of the command")                         \
  F(4, u8, kind, "Jog::Kind")                              \
  F(5, u8, frame, "FrameId")                               \
  F(6, u8, profile, "ProfileKind")                         \
  F(7, u8, reserved, "0")                                  \
  F(8, i64, duration, "ticks")                             \
  F(16, f64x6, joints, "rad/s")                            \
  F(64, f64x3, move, "of the tool, mm/s")                  \
  F(88, f64x3, turn, "of the tool, rad/s")                 \
  F(112, f64, accel_share, "of the joints' accelerations") \
  F(120, f64, accel, "of the tool, mm/s^2")                \
  F(128, f64, turn_accel, "of the tool, rad/s^2")          \
  F(136, f64, jerk, "of the tool, mm/s^3")                 \
  F(144, f64, turn_jerk, "of the tool, rad/s^3")
ARMATURE_BLOCK(JogBlock, ARMATURE_JOG);

#define ARMATURE_STREAM_POINT(F)               \
  F(0, u32, tag, "of the stream")              \
  F(4, u8, kind, "StreamPoint::Kind")          \
  F(5, u8, first, "flag")                      \
  F(6, u8, last, "flag")                       \
  F(7, u8, profile, "ProfileKind")             \
  F(8, i64, time, "ticks since the first one") \
  F(16, i64, delay, "ticks")                   \
  F(24, f64x6, joints, "rad")                  \
  F(72, f64x3, position, "of the tool, mm")    \
  F(96, f64x9, rotation, "of the tool")
ARMATURE_BLOCK(StreamPointBlock, ARMATURE_STREAM_POINT);

#define ARMATURE_CONVEYOR_PART(F) F(0, i64, counts, "of the encoder of the belt")
ARMATURE_BLOCK(ConveyorPartBlock, ARMATURE_CONVEYOR_PART);

#define ARMATURE_HOME(F)                           \
  F(0, u32, tag, "of the command")                 \
  F(4, u8, axes, "mask, bit 0 for axis 1; 0: all") \
  F(5, u8x3, reserved, "0")
ARMATURE_BLOCK(HomeBlock, ARMATURE_HOME);

#define ARMATURE_CLEAR_FAULT(F) F(0, u32, tag, "of the command")
ARMATURE_BLOCK(ClearFaultBlock, ARMATURE_CLEAR_FAULT);

#define ARMATURE_SWITCH_OFF(F) F(0, u32, tag, "of the command")
ARMATURE_BLOCK(SwitchOffBlock, ARMATURE_SWITCH_OFF);

#define ARMATURE_STOP(F)       \
  F(0, u8, kind, "Stop::Kind") \
  F(1, u8x3, reserved, "0")
ARMATURE_BLOCK(StopBlock, ARMATURE_STOP);

// Hold and Resume.
#define ARMATURE_PLAIN_COMMAND(F) F(0, u32, reserved, "0")
ARMATURE_BLOCK(PlainCommandBlock, ARMATURE_PLAIN_COMMAND);

using CommandBody = std::array<u8, sizeof(CartesianMoveBlock)>;
#define ARMATURE_COMMAND(F)                        \
  F(0, u32, kind, "kind of the block in the body") \
  F(4, u32, reserved, "0")                         \
  F(8, CommandBody, body, "the block, padded with 0")
ARMATURE_BLOCK(CommandBlock, ARMATURE_COMMAND);

}  // namespace armature::mailbox
