// All commands that the controller accepts. A command contains no text and no units to parse.
//
// The events of a command repeat its `tag`. Each circle, line or arc of a chain keeps its own tag.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>

#include "controller/base/axes.hpp"
#include "controller/base/members.hpp"
#include "controller/base/tag.hpp"
#include "controller/base/units.hpp"
#include "controller/message/tool_velocity_limits.hpp"
#include "controller/trajectory/plan/cartesian_planner.hpp"
#include "controller/trajectory/profile/time_law.hpp"

namespace armature {

// The frame in which a set-point is given.
struct FrameId {
  std::uint8_t index = 0;
  friend constexpr bool operator==(FrameId, FrameId) noexcept = default;
  ARMATURE_MEMBERS(FrameId, index)
};
inline constexpr std::size_t kUserFrames = 16;
inline constexpr FrameId kBaseFrame{0};  // user frames are 1..kUserFrames
// The frame of the part that the arm follows, see ConveyorPart; for CartesianMove only.
inline constexpr FrameId kConveyorFrame{kUserFrames + 1};
inline constexpr FrameId kToolFrame{255};  // the tool's own frame at the start of the move: for relative motions

// A pose of the tool centre point in a frame.
struct FramedPose {
  FrameId frame = kBaseFrame;
  Eigen::Vector3d position_mm = Eigen::Vector3d::Zero();
  std::optional<Eigen::Matrix3d> rotation{};  // none: the tool keeps its orientation, see ArmPlane::kept()
  Configuration configuration{};  // of the arm; PoseMove: what is not requested is nearest to the previous one
  ARMATURE_MEMBERS(FramedPose, frame, position_mm, rotation, configuration)
};

// How a joint move passes its target when another joint move or a path follows: without a stop, at a distance. It is
// the largest deviation of any joint at the closest set-point (joint/joint_chain.hpp, plan/path_joint_corner.hpp). The
// next move must be submitted before the first one is sent to core 0. A chain has at most JointChain::kMaxMoves moves.
// The joints stop exactly if the next move comes too late, is of another kind, begins at once or was refused. At most
// one of both is above 0.
struct JointBlend {
  double rad = 0.0;
  // [0, 1]; of half the way of the joint that moves farthest, in the shorter one of both moves. Half the way of a path
  // is that on the first half of its first segment, in time.
  double share = 0.0;

  [[nodiscard]] bool wanted() const noexcept { return rad > 0.0 || share > 0.0; }
  ARMATURE_MEMBERS(JointBlend, rad, share)
};

// Moves all joints; they start and stop together.
struct JointMove {
  PerAxis<Radians> target{};  // absolute joint angles
  double speed = 1.0;         // scale of the speed limits, (0, 1]; a move of more than 24 h is refused
  double accel = 1.0;         // scale of the acceleration limits, (0, 1]
  ProfileKind profile = ProfileKind::kTrapezoid;  // kSCurve: the robot must have jerk limits
  // True: begins at once, from the present state of motion, and replaces all moves that were accepted before it; those
  // that have not begun are refused (kReplaced). It is refused, and those moves continue, if a joint cannot stop before
  // its soft limit (kOutsideLimits), and during a jog (kNotReady). In a Hold it waits for the Resume, after a Stop for
  // the rest. A later one replaces it.
  bool now = false;
  JointBlend blend{};     // no effect with `now`
  PathOutputs outputs{};  // in time; none with `now`
  Tag tag{};
  ARMATURE_MEMBERS(JointMove, target, speed, accel, profile, now, blend, outputs, tag)
};

// A joint move to a tool pose. Of the branches of the inverse kinematics in the requested configuration it selects the
// one with the shortest move.
struct PoseMove {
  FramedPose target{};
  double speed = 1.0;
  double accel = 1.0;
  ProfileKind profile = ProfileKind::kTrapezoid;
  JointBlend blend{};
  PathOutputs outputs{};  // in time
  Tag tag{};
  ARMATURE_MEMBERS(PoseMove, target, speed, accel, profile, blend, outputs, tag)
};

// Moves the tool along a line, an arc, a circle, a helix or a spline. Such moves form a chain while the tool need not
// stop between them: where a move has a blend radius, so that the corner may be rounded, and where the next one
// continues in the same direction. With a blend radius they also lead into a joint move, in one plan with the path.
//
//   an exact stop follows   if the next move comes after the arm began to brake at the end of the last one
//   is refused              what is not yet planned of a chain in which a move was refused
//   is refused              a move whose end has another configuration of the arm than its start
//   needs a stop before it  a spline that is not among the first moves (1), or beyond kMaxSplines of them
//   needs a stop before it  a joint move behind the first moves (1), with outputs in its plan, or with more moves in it
//                           than Plan::kMaxMoves
//   needs a stop before it  an output at a place on another move: behind the first moves (1), beyond TimedOutputs::kMax
//                           of them, and before the move behind it
//   needs a stop before it  an S-curve behind trapezoids and behind the first moves (1)
//
// (1) The first CartesianPlan::kMaxFirstSegments moves, if they come before their planning has ended.
struct CartesianMove {
  // kSteady: from the orientation at the start to that of the target, about one axis. Five joints: see
  // five_axis_turning.hpp. kFixed: keeps the orientation. kTangent: turns with the tangent of the path. Both need a
  // target without rotation. kSlerp: about one axis in space, also with a tilted tool on five joints.
  enum class Orientation : std::uint8_t { kSteady, kFixed, kTangent, kSlerp };
  static constexpr double kMaxTolerance_rad = 0.6;
  SegmentRequest::Kind kind = SegmentRequest::Kind::kLine;
  FramedPose target{};  // kCircle: its position is the third point
  // In the frame of the target. kArc, kCircle: second point; kArcAbout: a point of the axis.
  Eigen::Vector3d via_mm = Eigen::Vector3d::Zero();
  AboutAxis about{};        // kArcAbout: in the frame of the target, whose position has no effect
  ThroughPoints through{};  // kSpline: in the frame of the target
  // Switched at places of the path without a stop: within a tick of the moment at which the pulses reach the place.
  // Core 0 does it. A stop or a fault leaves out those whose place the arm does not reach.
  PathOutputs outputs{};
  PathLimits limits{};
  ProfileKind profile = ProfileKind::kTrapezoid;
  double blend_mm = 0.0;
  bool exact_stop = false;  // the tool stops at the end in any case; not together with a blend radius
  bool rapid = false;       // a way to the next place of work, G0; only events and pictures tell it from others
  Orientation orientation = Orientation::kSteady;
  AtSingularity at_singularity = AtSingularity::kSlow;
  double orientation_tolerance_rad = 0.0;  // kBend: above 0, at most kMaxTolerance_rad
  Tag tag{};
  ARMATURE_MEMBERS(CartesianMove, kind, target, via_mm, about, through, outputs, limits, profile, blend_mm, exact_stop,
                   rapid, orientation, at_singularity, orientation_tolerance_rad, tag)
};

// Stands still between two moves, for exactly this time from the last set-point of the move before to the start of the
// next one. An override has no effect on it. A Hold interrupts it, and it continues with the rest of its time.
struct Dwell {
  Ticks duration{};  // > 0, at most 24 h
  Tag tag{};
  ARMATURE_MEMBERS(Dwell, duration, tag)
};

// Commands for the tool's pins are executed in sequence with the moves. Each is executed when the arm is at the end of
// the previous move, that is when the last pulse of that move is out; the drives may still settle. The moves behind it
// are planned after that. So a pin command ends a chain: the arm stops there. During a Hold no pin command begins, but
// a wait that has begun continues. A Stop or a fault drops pin commands like moves and leaves the outputs unchanged.

// Switches an output.
struct SetOutput {
  std::uint8_t pin = 0;  // 1..16
  bool level = false;
  Tag tag{};
  ARMATURE_MEMBERS(SetOutput, pin, level, tag)
};

// Delays the commands behind it until an input has the requested level; no delay if it has that level already. The
// level must last for a few microseconds. After a time-out this command and all that wait behind it are refused
// (kInputTimeout).
struct WaitInput {
  std::uint8_t pin = 0;  // 1..16
  bool level = false;
  Ticks timeout{};  // counted from the start of the wait, Holds included; detected within two ticks. 0: no time-out; at
                    // most 24 h
  Tag tag{};
  ARMATURE_MEMBERS(WaitInput, pin, level, timeout, tag)
};

// Brakes on the path and stands there, ready to continue. Plans and waiting moves stay in the queue. So do moves that
// are submitted meanwhile. No move begins before a Resume, even if the arm stood at rest when the Hold came. A Stop or
// a fault ends a Hold. A Hold in Fault holds the first move after the fault. No effect while already held.
struct Hold {
  ARMATURE_MEMBERS(Hold)
};
// Continues after a Hold on the same path. No effect while not held.
struct Resume {
  ARMATURE_MEMBERS(Resume)
};
// Feed override: executes all paths at this share of their planned rate, 0.01 .. 1 in steps of one millionth. It
// applies at once, until the next SetOverride, and does not change the path. Stops and faults do not change it.
struct SetOverride {
  double share = 1.0;
  Tag tag{};
  ARMATURE_MEMBERS(SetOverride, share, tag)
};

// Moves the joints or the tool with a velocity, under the limits of acceleration: for jogging. Accepted only when the
// arm stands at the end of all moves without a Hold, or jogs; otherwise refused (kNotReady). The next Jog replaces it.
// When its duration has passed, at a Hold and at a soft Stop, the arm comes to rest within the limits of the latest
// Jog. At a quick Stop it does so with the full acceleration of the joints. Moves that come meanwhile begin after that.
// An override has no effect on it. At soft limits, singularities and the limits of the reach it stops as described in
// activity/jog/velocity_source.hpp. All Jogs from rest to rest are one jog, which has one JogStarted and one JogEnded.
struct Jog {
  enum class Kind : std::uint8_t { kJoints, kTool };
  Kind kind = Kind::kJoints;
  PerAxis<double> joint_rad_s{};  // kJoints: limited to the speeds of the axes; 0 for axes that the robot does not have
  FrameId frame = kBaseFrame;     // kTool; kToolFrame: its axes turn with the tool
  Eigen::Vector3d move_mm_s = Eigen::Vector3d::Zero();   // kTool: velocity of the tool centre point
  Eigen::Vector3d turn_rad_s = Eigen::Vector3d::Zero();  // kTool
  Ticks duration{};                                      // > 0, at most 24 h
  // kSCurve: kJoints limits the jerk of the joints, which the robot must define; kTool that of the tool.
  ProfileKind profile = ProfileKind::kTrapezoid;
  double accel_share = 1.0;   // kJoints: of the axes' acceleration limits, (0, 1]
  ToolVelocityLimits tool{};  // kTool; jerks have an effect only with kSCurve
  Tag tag{};
  ARMATURE_MEMBERS(Jog, kind, joint_rad_s, frame, move_mm_s, turn_rad_s, duration, profile, accel_share, tool, tag)
};

// Finds the joint angles of axes by their home switches and index pulses (activity/homing/axis_homing.hpp), in the
// order of HomingModel::order, and moves these axes to their home positions. Accepted only when the arm stands at the
// end of all moves without a Hold; otherwise refused (kNotReady). A Stop, a Hold and an axis that fails end it. Moves
// that come meanwhile begin after that. An override has no effect. Each axis has one HomingStarted and one HomingEnded.
//
// From its start on the angles of these axes are not known, until each has reached its home position. The same holds
// for all axes after an unreferenced start (ControllerConfig::referenced). Meanwhile, moves and what waits with them
// are refused (kNotReferenced), and so are Jogs and streams.
struct Home {
  std::uint8_t axes = 0;  // mask, bit 0 for axis 1; 0: all axes of the robot
  Tag tag{};
  ARMATURE_MEMBERS(Home, axes, tag)
};

// One set-point of a stream, from a client that sends them at a fixed rate. The first one is accepted only when the arm
// stands at the end of all moves without a Hold; otherwise it is refused (kNotReady), and the others have no effect. A
// set-point of the tool must be in reach of the branch of the arm of the one before; otherwise it is refused, and the
// stream stops. A Stop and a Hold stop it as well, a quick Stop also while it brakes. Moves that come meanwhile begin
// after that. An override has no effect. How the arm follows: activity/stream/stream_source.hpp. The end is reported as
// StreamEnded.
struct StreamPoint {
  enum class Kind : std::uint8_t { kJoints, kTool };
  Kind kind = Kind::kJoints;
  bool first = false;
  bool last = false;
  PerAxis<Radians> joints{};                               // kJoints; 0 for axes that the robot does not have
  Eigen::Vector3d position_mm = Eigen::Vector3d::Zero();   // kTool: tool centre point in the base frame
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  // kTool
  Ticks time{};                                            // since the first one, strictly ascending
  Ticks delay{};                                           // of the first one, > 0, see StreamSample
  ProfileKind profile = ProfileKind::kTrapezoid;           // of the first one
  Tag tag{};                                               // the same for the whole stream
  ARMATURE_MEMBERS(StreamPoint, kind, first, last, joints, position_mm, rotation, time, delay, profile, tag)
};

// A part has passed the sync point of the conveyor, when its encoder had this count. At most 16 parts wait; the oldest
// ones are dropped. No effect without a conveyor. It should not come from Source::kProgram, whose commands may wait.
//
// The first CartesianMove in kConveyorFrame after moves in other frames waits for the next part that has not passed the
// window. It begins when the part enters the window or, if that has happened, as soon as it is planned. The path is
// executed in the frame of the part, which takes up the velocity of the belt meanwhile. Later moves in kConveyorFrame,
// dwells and commands for pins are executed while the arm follows the part. The first move in another frame makes the
// frame come to rest, and begins after that; a quick Stop brakes meanwhile, too. An override has no effect. A Stop and
// a Hold end the following, and so do a part that leaves the window, a belt that is too fast, and a set-point outside
// the limits of the joints; all moves that wait are then refused (kPartLost; after a Stop kNotReady). Reported as
// PartFollowed.
struct ConveyorPart {
  std::int64_t counts = 0;
  ARMATURE_MEMBERS(ConveyorPart, counts)
};

// Brakes on the path, drops queued moves (each is reported as refused), ends in Idle. It also ends a Hold, and the held
// move does not continue. In Fault the arm stands already. The drives stay enabled: category 2 of IEC 60204-1. A quick
// stop replaces a soft one that is braking.
struct Stop {
  enum class Kind : std::uint8_t {
    kQuick,  // with the full acceleration of the joints, whatever the limits of the move; jerk is not limited
    kSoft    // within the limits of the move, as a Hold
  };
  Kind kind = Kind::kQuick;
  ARMATURE_MEMBERS(Stop, kind)
};

// Leaves Fault when its cause is gone: clears the latches of the logic, enables the drives, sets the reference to the
// present encoder position. It is reported as refused, and has no effect, while the cause persists, while the arm still
// moves, or when the hardware was not identified. Outside Fault it has no effect and reports nothing. The same holds
// for a second one before the first is answered.
struct ClearFault {
  Tag tag{};
  ARMATURE_MEMBERS(ClearFault, tag)
};

// Switches the drives off: Fault with the cause kDrivesOff, which a ClearFault leaves. Refused (kNotReady) unless the
// arm stands at the end of all moves without a Hold.
struct SwitchOff {
  Tag tag{};
  ARMATURE_MEMBERS(SwitchOff, tag)
};

using Command = std::variant<JointMove, PoseMove, CartesianMove, SetOutput, WaitInput, Hold, Resume, SetOverride, Stop,
                             ClearFault, Jog, StreamPoint, Dwell, ConveyorPart, Home, SwitchOff>;

}  // namespace armature
