#include "controller/pendant/client/command_table.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "controller/drivers/axi_gpio.hpp"

namespace armature::pendant {
namespace {

struct Call {
  PendantParts& parts;
  std::uint8_t parameter;
  std::int32_t payload;
  RegisterBus& bus;
  Cycles now;

  [[nodiscard]] double share() const noexcept { return payload / 10'000.0; }
};
// None: an event will answer.
using Result = std::optional<Answer>;

Result switch_drives(const Call& call) noexcept {
  const bool on = static_cast<Drives>(call.parameter) == Drives::kOn;
  if (on == call.parts.arm.drives_on()) return Answer{};
  if (!on) return call.parts.commands.give(SwitchOff{});
  call.parts.drives.request();
  return std::nullopt;
}

Result start_motion(const Call& call, const Command& command) noexcept {
  call.parts.motion_is_ours = true;
  return call.parts.commands.give(command);
}

Result home(const Call& call) noexcept {
  call.parts.arm.expect_homing(call.parameter);
  return start_motion(call, Home{.axes = call.parameter});
}

void jog(const Call& call) noexcept {
  static_cast<void>(start_motion(call, call.parts.manual.jog(call.now)));
}

// `make`: a function of Coordinates.
template <class Make>
Result move_staged(const Call& call, std::size_t points, Make make) noexcept {
  const std::optional<StagedMove> staged = call.parts.manual.take_staged(points, call.payload);
  if (!staged) return Answer{.status = Status::kCheckFail};
  return start_motion(call, (call.parts.manual.coordinates().*make)(*staged));
}

// What the commands for programs use. Core 1 then executes the program at once.
Programs& programs(const Call& call) noexcept {
  call.parts.program_ordered = true;
  return call.parts.programs;
}

Answer run_program(const Call& call) noexcept {
  const Coordinates& coordinates = call.parts.manual.coordinates();
  if (const Status status = programs(call).may_run(coordinates); status != Status::kOk) return {.status = status};
  call.parts.motion_is_ours = false;
  return programs(call).run(static_cast<RunMode>(call.parameter), static_cast<std::uint32_t>(call.payload),
                            coordinates.user_frame());
}

// A command, and what executes it: a function object without state. It may return nothing, which means kOk.
struct Entry {
  template <class Execute>
  constexpr Entry(Opcode code, Execute) noexcept
      : opcode{code}, execute{[](const Call& call) noexcept -> Result {
          if constexpr (std::is_void_v<std::invoke_result_t<Execute, const Call&>>) {
            Execute{}(call);
            return Answer{};
          } else {
            return Execute{}(call);
          }
        }} {}

  Opcode opcode;
  Result (*execute)(const Call& call) noexcept;
};

constexpr auto kCommands = std::to_array<Entry>({
    {Opcode::kHeartbeat, [](const Call&) {}},
    {Opcode::kEcho, [](const Call& call) { return Answer{.payload = call.payload}; }},
    {Opcode::kGetStatus,
     [](const Call& call) { return Answer{.payload = call.parts.telemetry.value(call.parameter, call.now)}; }},
    {Opcode::kSetTelemetry,
     [](const Call& call) { call.parts.telemetry.select(call.parameter, call.payload, call.now); }},
    {Opcode::kResetAlarm, [](const Call& call) { call.parts.arm.reset_alarm(); }},
    {Opcode::kEstopReset, [](const Call& call) { call.parts.arm.reset_estop(); }},
    {Opcode::kServo, [](const Call& call) { return switch_drives(call); }},
    {Opcode::kHome, [](const Call& call) { return home(call); }},
    {Opcode::kStop,
     [](const Call& call) {
       static_cast<void>(call.parts.programs.abort());
       call.parts.stop(Stop::Kind::kQuick);
     }},
    {Opcode::kSetCoordinates, [](const Call& call) { call.parts.manual.select(static_cast<System>(call.parameter)); }},
    {Opcode::kSetUserFrame, [](const Call& call) { call.parts.manual.select_user(call.parameter); }},
    {Opcode::kSpeedOverride,
     [](const Call& call) { static_cast<void>(call.parts.commands.give(SetOverride{.share = call.share()})); }},
    {Opcode::kJogLimit, [](const Call& call) { call.parts.manual.set_jog_limit(call.share()); }},
    {Opcode::kJogContinuous,
     [](const Call& call) {
       call.parts.manual.press(call.parameter, call.share(), call.now);
       jog(call);
     }},
    {Opcode::kJogStop,
     [](const Call& call) {
       call.parts.manual.release();
       if (call.parts.arm.jogs(call.now)) jog(call);
     }},
    {Opcode::kTarget,
     [](const Call& call) {
       const bool exists = call.parts.manual.stage_target(call.parameter, call.payload);
       return Answer{.status = exists ? Status::kOk : Status::kRange};
     }},
    {Opcode::kTargetOption,
     [](const Call& call) {
       call.parts.manual.stage_option(static_cast<MoveOption>(call.parameter), call.payload);
     }},
    {Opcode::kJogIncrement,
     [](const Call& call) {
       const PerAxis<Radians> present = call.parts.position.reference();
       return start_motion(call, call.parts.manual.increment(call.parameter, call.payload, present));
     }},
    {Opcode::kMoveJoints, [](const Call& call) { return move_staged(call, 1, &Coordinates::joint_move); }},
    {Opcode::kMoveLine, [](const Call& call) { return move_staged(call, 1, &Coordinates::line); }},
    {Opcode::kMoveArc, [](const Call& call) { return move_staged(call, 2, &Coordinates::arc); }},
    {Opcode::kSetOutput,
     [](const Call& call) {
       return call.parts.commands.give(SetOutput{.pin = call.parameter, .level = call.payload == 1});
     }},
    {Opcode::kReadInput,
     [](const Call& call) { return Answer{.payload = AxiGpio{call.bus}.input(call.parameter) ? 1 : 0}; }},
    {Opcode::kProgramBegin,
     [](const Call& call) { return programs(call).begin(static_cast<Content>(call.parameter), call.payload); }},
    {Opcode::kProgramCommit,
     [](const Call& call) { return programs(call).commit(call.payload, call.parts.line, call.bus); }},
    {Opcode::kProgramCancel, [](const Call& call) { programs(call).cancel(); }},
    {Opcode::kProgramSelect, [](const Call& call) { return programs(call).select(call.parameter); }},
    {Opcode::kRun, [](const Call& call) { return run_program(call); }},
    {Opcode::kHold, [](const Call& call) { return programs(call).hold(); }},
    {Opcode::kResume, [](const Call& call) { return programs(call).resume(); }},
    {Opcode::kStep, [](const Call& call) { return programs(call).step(); }},
    {Opcode::kAbort, [](const Call& call) { return programs(call).abort(); }},
    {Opcode::kSetBreakpoint,
     [](const Call& call) {
       return programs(call).set_breakpoint(static_cast<BreakpointAction>(call.parameter),
                                            static_cast<ProgramPlace>(call.payload));
     }},
});

constexpr bool complete() noexcept {
  return std::ranges::all_of(kOpcodeRules, [](const OpcodeRule& rule) {
    return std::ranges::count(kCommands, rule.opcode, &Entry::opcode) == (rule.reply_only ? 0 : 1);
  });
}
static_assert(complete(), "each command of frames.toml has one entry");

}  // namespace

std::optional<Answer> execute_command(const Frame& command, PendantParts& parts, RegisterBus& bus,
                                      Cycles now) noexcept {
  const Entry* entry = std::ranges::find(kCommands, command.opcode, &Entry::opcode);
  if (entry == kCommands.end()) return Answer{.status = Status::kUnknown};
  return entry->execute(
      {.parts = parts, .parameter = command.parameter, .payload = command.payload, .bus = bus, .now = now});
}

}  // namespace armature::pendant
