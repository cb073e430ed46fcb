#include "controller/pendant/client/pendant_client.hpp"

#include <utility>
#include <variant>

#include "controller/pendant/client/command_table.hpp"

namespace armature::pendant {
namespace {

constexpr Cycles kMaxSilence{500 * kMillisecond.value()};

}  // namespace

bool PendantClient::execute(RegisterBus& bus) noexcept {
  PendantLine& line = parts_.line;
  now_ = bus.now();
  parts_.drives.update(now_);
  if (!line.started()) line.start(bus);
  // Planning keeps core 1 busy, and an emergency stop must not wait for it.
  line.poll(bus);
  if (line.take_estop()) on_estop();
  if (const std::optional<Answer> answer = parts_.commands.take_answer()) reply(*answer);
  while (const std::optional<FrameBytes> frame = line.next_frame()) on_frame(*frame, bus);
  switch_on_when_due();
  watch_the_line();
  parts_.telemetry.send_when_due(line, now_);
  line.flush();
  const bool ordered = std::exchange(parts_.program_ordered, false);
  return parts_.commands.take_given() || ordered;
}

bool PendantClient::waits_for_time() const noexcept {
  return parts_.telemetry.periodic() || parts_.drives.requested() ||
         (parts_.motion_is_ours && parts_.arm.moves(now_)) || watches_program();
}

void PendantClient::on_event(const Event& event) noexcept {
  parts_.arm.on_event(event);
  parts_.commands.on_event(event);
  if (const auto* fault = std::get_if<Faulted>(&event)) {
    parts_.manual.release();
    parts_.motion_is_ours = false;
    parts_.drives.on_fault(fault->cause);
  }
  const auto* refused = std::get_if<MoveRefused>(&event);
  if (refused == nullptr || refused->tag.source() != Source::kPendant) return;
  if (!parts_.commands.awaits(refused->tag)) parts_.manual.release();  // a jog that was refused did not start
}

// The command that waits for an event is over, too: the events of the fault may not name it.
void PendantClient::on_estop() noexcept {
  parts_.arm.latch_estop();
  parts_.manual.release();
  send({.kind = Kind::kReply, .opcode = Opcode::kEstop});
  parts_.drives.cancel();
  if (parts_.commands.awaits_any()) parts_.commands.set_answer({.status = Status::kEstopLatched});
}

void PendantClient::on_frame(const FrameBytes& bytes, RegisterBus& bus) noexcept {
  last_frame_at_ = now_;
  if (kind_of(bytes) == Kind::kBulk) {
    if (const std::optional<Frame> reply = parts_.programs.push(decode_bulk(bytes))) send(*reply);
    return;
  }
  const Frame command = decode(bytes);
  const CommandLink::Decision decision = link_.on_command(command);
  if (decision.reply) send(*decision.reply);
  if (!decision.execute) return;
  const Status admitted = admission(command, parts_.arm.state(now_), parts_.profile);
  const std::optional<Answer> answer =
      admitted == Status::kOk ? execute_command(command, parts_, bus, now_) : std::optional{Answer{.status = admitted}};
  if (answer) {
    reply(*answer);
  } else {
    parts_.commands.await(command.opcode);
  }
}

void PendantClient::switch_on_when_due() noexcept {
  if (!parts_.drives.take_due(now_)) return;
  ArmCommands& commands = parts_.commands;
  commands.end_waiting();
  if (const std::optional<Answer> busy = commands.give(ClearFault{})) commands.set_answer(*busy);
  commands.await(Opcode::kServo);
}

void PendantClient::watch_the_line() noexcept {
  if (now_ - last_frame_at_ <= kMaxSilence) return;
  if (watches_program()) {
    parts_.program_ordered = parts_.programs.hold().status == Status::kOk || parts_.program_ordered;
  } else if (std::exchange(parts_.motion_is_ours, false) && parts_.arm.moves(now_)) {
    parts_.stop(Stop::Kind::kSoft);
  }
}

// With the profile `extended` a program that the pendant runs is held when the line is silent.
bool PendantClient::watches_program() const noexcept {
  return parts_.profile == Profile::kExtended && parts_.programs.runs();
}

void PendantClient::reply(const Answer& answer) noexcept {
  parts_.commands.end_waiting();
  if (const std::optional<Frame> frame = link_.answer(answer.status, answer.payload)) send(*frame);
}

}  // namespace armature::pendant
