// The memory that the controller shares with its host: the host writes commands, the controller writes events and
// telemetry. LAYOUT.md describes it. It is the same, byte for byte, for every processor that runs the controller.
#pragma once

#include <array>

#include "controller/command/inbox.hpp"
#include "controller/core/tag.hpp"
#include "controller/mailbox/command_blocks.hpp"
#include "controller/mailbox/event_blocks.hpp"
#include "controller/mailbox/ring.hpp"
#include "controller/motion/mailbox.hpp"

namespace armature::mailbox {

inline constexpr u32 kMagic = 0x424D'5241;  // "ARMB"
inline constexpr u32 kLayoutVersion = 15;   // increased with every change of a block

// The host reads the rings of events each time a core has run and then waits: for a register access, for an interrupt,
// or for time to pass. Between two reads the controller cannot cause more events than these rings hold:
//   core 0  executes at most one tick. The moves of the active plan finish, at most one plan starts and finishes, all
//           other moves are refused, outputs on a path are switched, a jog starts and ends, a stream ends, a part on
//           the conveyor is followed and lost, each axis starts and ends to be homed, and Fault is entered or left.
//           While a part is followed no plan waits.
//   core 1  answers each of its commands at most once: those in the inboxes, those that wait, one chain. A part on the
//           conveyor is missed. A program executes at most one step.
using CommandRing = Ring<CommandBlock, 16>;
using Core0Events = Ring<EventBlock, 1024>;
using Core1Events = Ring<EventBlock, 512>;
inline constexpr std::size_t kMaxWaitingMoves = 16;  // Dispatcher::kWaitingMoves
inline constexpr std::size_t kMaxProgramNotes = 66;  // of one step of a program
static_assert(Core0Events::kCapacity >=
              MotionMailbox::kMoves + 2 * CartesianPlan::kMaxFirstSegments + 2 * TimedOutputs::kMax + 2 * kAxes + 9);
static_assert(Core1Events::kCapacity >=
              kSources * kInboxCommands + kMaxWaitingMoves + CartesianPlan::kMaxSegments + kMaxProgramNotes + 2);
static_assert(kInboxCommands == CommandRing::kCapacity, "an inbox takes all that is in its ring");

using CommandRings = std::array<CommandRing, kHostSources>;

#define ARMATURE_MAILBOX_MEMORY(F)                                                \
  F(0, u32, magic, "0x424D5241: the host has prepared the memory")                \
  F(4, u32, layout_version, "1")                                                  \
  F(8, u32, bytes, "size of the whole memory")                                    \
  F(12, u32, reserved, "0")                                                       \
  F(16, TelemetryBlock, telemetry, "of the last tick; written by core 0")         \
  F(336, CommandRings, commands, "one ring for each source, written by the host") \
  F(21872, Core0Events, core0_events, "written by core 0")                        \
  F(701824, Core1Events, core1_events, "written by core 1")                       \
  F(1041808, i64, belt_counts, "encoder of the conveyor, written by the host")
ARMATURE_BLOCK(Memory, ARMATURE_MAILBOX_MEMORY);

}  // namespace armature::mailbox
