#include "controller/pendant/pendant_client.hpp"

#include <utility>
#include <variant>

#include "controller/base/timebase.hpp"
#include "controller/drivers/axi_gpio.hpp"
#include "controller/pendant/refusal_status.hpp"

namespace armature::pendant {
namespace {

constexpr Cycles kLongestSilence{500 * kMillisecond.value()};
constexpr std::int32_t kShortestPeriod = 20;  // ms
// Tags of the pendant are behind those of scenarios.
constexpr std::uint32_t kFirstTag = 0x00C0'0000;

}  // namespace

PendantClient::PendantClient(const PendantConfig& config, const RobotModel& robot, const Arm& arm,
                             const PlanningConfig& planning, const ArmPosition& position, Inbox& inbox,
                             ProgramClient& program) noexcept
    : config_{config},
      position_{position},
      inbox_{inbox},
      program_{program},
      line_{config.paper_logic},
      coordinates_{robot, arm, planning},
      store_{{.robot = robot, .arm = arm, .flange_T_tool = planning.flange_T_tool, .base_T_user = planning.base_T_user},
             config.job,
             config.gcode} {}

bool PendantClient::execute(RegisterBus& bus) noexcept {
  gave_ = false;
  now_ = bus.now();
  if (settling_ > Cycles{0}) drives_on_at_ = now_ + std::exchange(settling_, Cycles{0});
  if (!line_.started()) line_.start(bus);
  // Planning keeps core 1 busy, and an emergency stop must not wait for it.
  line_.poll(bus);
  if (line_.take_estop()) on_estop();
  if (answer_) reply(*std::exchange(answer_, std::nullopt));
  while (const std::optional<FrameBytes> frame = line_.next_frame()) on_frame(*frame, bus);
  switch_on_when_due();
  watch_the_line();
  send_telemetry();
  line_.flush();
  return gave_;
}

bool PendantClient::waits_for_time() const noexcept {
  return period_ > Cycles{0} || drives_wanted_ || (mine_ && moves()) || watches_program();
}

State PendantClient::state() const noexcept {
  ArmFacts facts = arm_facts_;
  facts.program = program_.active();
  facts.held = program_.state() == ProgramClient::State::kPaused || program_.state() == ProgramClient::State::kHeld;
  facts.jog = jogs_ || pressed_.any(now_);
  facts.move = moves_ > 0 || homing_ != 0;
  return state_of(facts);
}

bool PendantClient::moves() const noexcept {
  return jogs_ || pressed_.any(now_) || moves_ > 0 || homing_ != 0;
}

void PendantClient::on_frame(const FrameBytes& bytes, RegisterBus& bus) noexcept {
  heard_ = now_;
  if (kind_of(bytes) == Kind::kBulk) {
    if (const std::optional<Frame> reply = store_.push(decode_bulk(bytes))) line_.send(encode(*reply));
    return;
  }
  const Frame command = decode(bytes);
  const CommandLink::Decision decision = link_.on_command(command);
  if (decision.reply) line_.send(encode(*decision.reply));
  if (!decision.execute) return;
  const Status admitted = admission(command, state(), config_.profile);
  const std::optional<Answer> answer =
      admitted == Status::kOk ? execute_command(command, bus) : std::optional{Answer{.status = admitted}};
  if (answer) {
    reply(*answer);
  } else {
    waits_ = command.opcode;
  }
}

std::optional<Answer> PendantClient::execute_command(const Frame& command, RegisterBus& bus) noexcept {
  switch (command.opcode) {
    case Opcode::kHeartbeat:
      return Answer{};
    case Opcode::kEcho:
      return Answer{.payload = command.payload};
    case Opcode::kGetStatus:
      return Answer{.payload = page(command.parameter)};
    case Opcode::kSetTelemetry:
      pages_ = command.parameter;
      period_ = command.payload < kShortestPeriod ? Cycles{0} : Cycles{command.payload * kMillisecond.value()};
      telemetry_at_ = now_;
      return Answer{};
    case Opcode::kResetAlarm:
      arm_facts_.alarm = false;
      return Answer{};
    case Opcode::kEstopReset:
      arm_facts_.estop = false;
      arm_facts_.alarm = true;
      return Answer{};
    case Opcode::kServo:
      return switch_drives(static_cast<Drives>(command.parameter) == Drives::kOn);
    case Opcode::kHome:
      return home(command.parameter);
    case Opcode::kStop:
      static_cast<void>(program_.abort());
      return stop(Stop::Kind::kQuick);
    case Opcode::kSetCoordinates:
      coordinates_.select(static_cast<System>(command.parameter));
      staged_.clear();
      return Answer{};
    case Opcode::kSetUserFrame:
      coordinates_.select_user(command.parameter);
      staged_.clear();
      return Answer{};
    case Opcode::kSpeedOverride:
      static_cast<void>(give(SetOverride{.share = command.payload / 10'000.0}));
      return Answer{};
    case Opcode::kJogLimit:
      jog_limit_ = command.payload / 10'000.0;
      return Answer{};
    case Opcode::kJogContinuous:
      pressed_.press(command.parameter, command.payload / 10'000.0, now_);
      jog();
      return Answer{};
    case Opcode::kJogStop:
      pressed_.release();
      if (jogs_) jog();
      return Answer{};
    case Opcode::kTarget:
    case Opcode::kTargetOption:
      return stage(command);
    case Opcode::kJogIncrement:
    case Opcode::kMoveJoints:
    case Opcode::kMoveLine:
    case Opcode::kMoveArc:
      return move(command);
    case Opcode::kSetOutput:
      return give(SetOutput{.pin = command.parameter, .level = command.payload == 1});
    case Opcode::kReadInput:
      return Answer{.payload = AxiGpio{bus}.input(command.parameter) ? 1 : 0};
    case Opcode::kProgramBegin:
    case Opcode::kProgramCommit:
    case Opcode::kProgramCancel:
    case Opcode::kProgramSelect:
    case Opcode::kRun:
    case Opcode::kHold:
    case Opcode::kResume:
    case Opcode::kStep:
    case Opcode::kAbort:
    case Opcode::kSetBreakpoint:
      return program_command(command, bus);
    case Opcode::kProgramData:
    case Opcode::kEstop:
      break;
  }
  return Answer{.status = Status::kUnknown};
}

std::optional<Answer> PendantClient::switch_drives(bool on) noexcept {
  if (on == arm_facts_.servo_on) return Answer{};
  if (!on) return give(SwitchOff{});
  drives_wanted_ = true;
  return std::nullopt;
}

void PendantClient::switch_on_when_due() noexcept {
  if (!drives_wanted_ || now_ < drives_on_at_) return;
  drives_wanted_ = false;
  waits_.reset();
  if (const std::optional<Answer> busy = give(ClearFault{})) answer_ = busy;
  waits_ = Opcode::kServo;
}

std::optional<Answer> PendantClient::move(const Frame& command) noexcept {
  const PerAxis<Radians> present = position_.reference();
  if (command.opcode == Opcode::kJogIncrement) {
    mine_ = true;
    return give(coordinates_.increment(command.parameter, command.payload, jog_limit_, present));
  }
  const std::size_t points = command.opcode == Opcode::kMoveArc ? 2 : 1;
  const bool good = staged_.complete(points, coordinates_.count()) && staged_.check() == command.payload;
  const StagedMove staged = std::exchange(staged_, {});
  if (!good) return Answer{.status = Status::kCheckFail};
  mine_ = true;
  if (command.opcode == Opcode::kMoveJoints) return give(coordinates_.joint_move(staged));
  return give(points == 2 ? coordinates_.arc(staged) : coordinates_.line(staged));
}

std::optional<Answer> PendantClient::home(std::uint8_t axes) noexcept {
  mine_ = true;
  homing_asked_ = axes;
  return give(Home{.axes = axes});
}

Answer PendantClient::stage(const Frame& command) noexcept {
  if (command.opcode == Opcode::kTargetOption) {
    staged_.stage_option(static_cast<MoveOption>(command.parameter), command.payload);
    return {};
  }
  return {.status = staged_.stage_target(command.parameter, command.payload) ? Status::kOk : Status::kRange};
}

void PendantClient::jog() noexcept {
  mine_ = true;
  static_cast<void>(give(coordinates_.jog(pressed_, jog_limit_, now_)));
}

Answer PendantClient::stop(Stop::Kind kind) noexcept {
  pressed_.release();
  static_cast<void>(give(Stop{.kind = kind}));
  return {};
}

std::optional<Answer> PendantClient::give(Command command) noexcept {
  const Tag tag{Source::kPendant, kFirstTag + ++commands_ % 0x0040'0000u};
  std::visit(
      [tag](auto& content) {
        if constexpr (requires { content.tag = tag; }) content.tag = tag;
      },
      command);
  if (!inbox_.try_push(command)) return Answer{.status = Status::kBusy};
  gave_ = true;
  if (!waits_) waits_for_ = tag;
  return std::nullopt;
}

// The command that waits for an event is over, too: the events of the fault may not name it.
void PendantClient::on_estop() noexcept {
  arm_facts_.estop = true;
  pressed_.release();
  line_.send(encode(Frame{.kind = Kind::kReply, .opcode = Opcode::kEstop}));
  drives_wanted_ = false;
  if (waits_) answer_ = Answer{.status = Status::kEstopLatched};
}

void PendantClient::watch_the_line() noexcept {
  if (now_ - heard_ <= kLongestSilence) return;
  if (watches_program()) {
    gave_ = program_.hold() || gave_;
  } else if (std::exchange(mine_, false) && moves()) {
    static_cast<void>(stop(Stop::Kind::kSoft));
  }
}

void PendantClient::reply(const Answer& answer) noexcept {
  waits_.reset();
  if (const std::optional<Frame> frame = link_.answer(answer.status, answer.payload)) line_.send(encode(*frame));
}

}  // namespace armature::pendant
