// The vocabulary of everything that can be asked of the controller; a command carries no text and no units to parse.
//
// The events of a command repeat its `tag`; a circle, line or arc of a chain keeps its own.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>

#include "controller/core/axes.hpp"
#include "controller/core/tag.hpp"
#include "controller/core/units.hpp"
#include "controller/trajectory/plan/cartesian_planner.hpp"
#include "controller/trajectory/profile/time_law.hpp"

namespace armature {

// The frame in which a set-point is given.
struct FrameId {
  std::uint8_t index = 0;
  friend constexpr bool operator==(FrameId, FrameId) noexcept = default;
};
inline constexpr std::size_t kUserFrames = 16;
inline constexpr FrameId kBaseFrame{0};    // user frames are 1..kUserFrames
inline constexpr FrameId kToolFrame{255};  // the tool's own frame where the move begins: relative motions

// A pose of the tool centre point in a frame.
struct FramedPose {
  FrameId frame = kBaseFrame;
  Eigen::Vector3d position_mm = Eigen::Vector3d::Zero();
  std::optional<Eigen::Matrix3d> rotation{};  // none: the tool keeps its own, see ArmPlane::kept()
};

// Moves all joints so that they start and stop together.
struct JointMove {
  PerAxis<Radians> target{};  // absolute joint angles
  double speed = 1.0;         // scale of the speed limits, (0, 1]; too slow when the move would take more than 24 h
  ProfileKind profile = ProfileKind::kTrapezoid;  // kSCurve: the robot must have jerk limits
  Tag tag{};
};

// The same to the joints that give the tool a pose: the branch that is reached soonest.
struct PoseMove {
  FramedPose target{};
  double speed = 1.0;
  ProfileKind profile = ProfileKind::kTrapezoid;
  Tag tag{};
};

// Moves the tool along a line, an arc or a circle. A move with a blend radius and the Cartesian move after it, when
// that has been submitted before the first one is planned, form a chain that goes through the corner without stopping;
// in all up to CartesianPlan::kMostSegments moves. One refused segment refuses its chain. Where the next move comes too
// late, is of another kind or was refused, the arm stops exactly.
struct CartesianMove {
  SegmentRequest::Kind kind = SegmentRequest::Kind::kLine;
  FramedPose target{};                               // kCircle: its position is the third point
  Eigen::Vector3d via_mm = Eigen::Vector3d::Zero();  // kArc, kCircle: in the frame of the target
  PathLimits limits{};
  ProfileKind profile = ProfileKind::kTrapezoid;
  double blend_mm = 0.0;
  Tag tag{};
};

// Commands for the pins of the tool take their turn among the moves: each is carried out when the arm stands at the end
// of the move before it, that is when the last pulse of that move is out (the drives may still settle), and the moves
// behind it are planned after that. So they end a chain: the arm stops there. None is carried out during a Hold; one
// that waits for an input already goes on waiting. A Stop or a fault drops them as it drops moves, and leaves the
// outputs as they are.

// Switches an output.
struct SetOutput {
  std::uint8_t pin = 0;  // 1..16
  bool level = false;
  Tag tag{};
};

// Holds back what is behind it until an input has a level; at once where it has it. The level must last for a few
// microseconds. When it has not come in time, this command and all that wait behind it are refused (kInputTimeout).
struct WaitInput {
  std::uint8_t pin = 0;  // 1..16
  bool level = false;
  Ticks timeout{};  // from when the wait begins, a Hold included; noticed within two ticks. 0: for ever; at most 24 h
  Tag tag{};
};

// Brakes on the path and stands there, ready to go on. What is planned or waiting stays, and so do moves submitted
// meanwhile: none begins before a Resume, also where the arm stood at rest when it was held. A Stop ends a hold, and so
// does a fault; one that is asked for in Fault holds the first move after it. Nothing while already held.
struct Hold {};
// Goes on after a Hold: the geometry is that of the move without it. Nothing while not held.
struct Resume {};
// Runs through all paths at this share of their speed, 0.01 .. 1 in millionths, from now on and until the next one;
// without leaving them. Stops and faults leave it as it is.
struct SetOverride {
  double share = 1.0;
  Tag tag{};
};

// Decelerates along the path with the axes' acceleration limits, drops queued moves (each is reported as refused), ends
// in Idle. Ends a Hold too, without going on. In Fault the arm stands anyway.
struct Stop {};

// Leaves Fault when its cause is gone: clears the latches of the logic, enables the drives, takes the present encoder
// position as the new reference. Reported as refused, and without effect, while the cause is there, the arm still moves
// or the hardware is not the controller's own. Outside Fault there is nothing to clear: it does nothing, silently; so
// does a second one before the first is answered.
struct ClearFault {
  Tag tag{};
};

using Command =
    std::variant<JointMove, PoseMove, CartesianMove, SetOutput, WaitInput, Hold, Resume, SetOverride, Stop, ClearFault>;

}  // namespace armature
