// The memory that the controller shares with its host: the host writes what the controller starts with, and then
// commands; the controller writes events and telemetry. LAYOUT.md describes it. It is the same, byte for byte, for
// every processor that runs the controller.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "controller/activity/channel.hpp"
#include "controller/base/tag.hpp"
#include "controller/host_memory/controller_config.hpp"
#include "controller/host_memory/layout.hpp"
#include "controller/host_memory/ring.hpp"
#include "controller/host_memory/slot.hpp"
#include "controller/language/store/program_files.hpp"
#include "controller/language/text/diagnostics.hpp"
#include "controller/message/command.hpp"
#include "controller/message/event.hpp"
#include "controller/message/inbox.hpp"
#include "controller/message/telemetry.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature::host_memory {

inline constexpr std::uint32_t kMagic = 0x424D'5241;  // "ARMB"

using CommandSlot = Slot<Command>;
using EventSlot = Slot<Event>;

// The host reads the rings of events each time a core has run and then waits: for a register access, for an interrupt,
// or for time to pass. Between two reads the controller cannot cause more events than these rings hold:
//   core 0  executes at most one tick. The moves of the active plan finish, at most one plan starts and finishes, all
//           other moves are refused, outputs on a path are switched, a jog starts and ends, a stream ends, a part on
//           the conveyor is followed and lost, each axis starts and ends to be homed, and Fault is entered or left.
//           While a part is followed no plan waits.
//   core 1  answers each of its commands at most once: those in the inboxes, those that wait, one chain. A part on the
//           conveyor is missed. A program executes at most one step.
using CommandRing = Ring<CommandSlot, 16>;
using Core0Events = Ring<EventSlot, 1024>;
using Core1Events = Ring<EventSlot, 512>;
inline constexpr std::size_t kMaxWaitingMoves = 16;  // MoveQueue::kMoves
inline constexpr std::size_t kMaxProgramNotes = 66;  // of one step of a program
static_assert(Core0Events::kCapacity >=
              PlanStore::kMoves + 2 * CartesianPlan::kMaxFirstSegments + 2 * TimedOutputs::kMax + 2 * kAxes + 9);
static_assert(Core1Events::kCapacity >=
              kSources * kInboxCommands + kMaxWaitingMoves + CartesianPlan::kMaxSegments + kMaxProgramNotes + 2);
static_assert(kInboxCommands == CommandRing::kCapacity, "an inbox takes all that is in its ring");

using CommandRings = std::array<CommandRing, kHostSources>;

// Why the controller has not started. It then does nothing more.
enum class BootProblem : std::uint8_t {
  kNone,         // it has started, or was not yet constructed
  kOtherLayout,  // the memory is not prepared, or host and controller were built with other lists of members
  kRobot,        // a block has a value that is not allowed
  kConfig,
  kProgram,
  kProgramText,  // the program does not load
};

struct BootReport {
  std::uint32_t problem{};  // BootProblem; written last
  std::uint32_t place{};    // kRobot, kConfig, kProgram: the first free byte of the block before the value
  std::array<char, DiagnosticText::kMaxSize> text{};  // kProgramText: FILE:LINE:COLUMN: what is wrong; then 0
  ARMATURE_MEMBERS(BootReport, problem, place, text)
};

template <class T>
using Block = std::array<std::uint8_t, kWireSize<T>>;

struct PublishedTelemetry {
  std::uint32_t published{};  // odd while the bytes are being written; 2 more with each tick
  std::uint32_t reserved{};
  Block<Telemetry> body{};
  ARMATURE_MEMBERS(PublishedTelemetry, published, reserved, body)
};

struct HostMemory {
  std::uint32_t magic{};      // kMagic: the host has prepared the memory
  std::uint32_t bytes{};      // size of the whole memory, with the texts behind this
  std::uint64_t layout{};     // layout_of_memory() of the host
  BootReport boot{};          // written by the controller; its place never changes
  Block<RobotModel> robot{};  // these three are written by the host before the controller starts
  Block<ControllerConfig> config{};
  Block<ProgramFiles> program{};   // the names of its files, and then their texts, stand behind this memory
  PublishedTelemetry telemetry{};  // of the last tick; written by core 0
  CommandRings commands{};         // one ring for each source, written by the host
  Core0Events core0_events{};      // written by core 0
  Core1Events core1_events{};      // written by core 1
  std::int64_t belt_counts{};      // latest sample of the conveyor's encoder or camera, written by the host
  std::uint32_t belt_sample{};     // its number, written after it
  std::uint32_t reserved{};
  ARMATURE_MEMBERS(HostMemory, magic, bytes, layout, boot, robot, config, program, telemetry, commands, core0_events,
                   core1_events, belt_counts, belt_sample, reserved)
};
static_assert(std::is_standard_layout_v<HostMemory>);

// Equal for two sides that agree on every byte of the memory.
[[nodiscard]] std::uint64_t layout_of_memory() noexcept;

}  // namespace armature::host_memory
