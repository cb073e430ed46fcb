#include "controller/pendant/parts/arm_commands.hpp"

#include <variant>

#include "controller/base/overloaded.hpp"
#include "controller/pendant/protocol/refusal_status.hpp"

namespace armature::pendant {
namespace {

// Tags of the pendant are behind those of scenarios.
constexpr std::uint32_t kFirstTag = 0x00C0'0000, kTags = 0x0040'0000;

}  // namespace

std::optional<Answer> ArmCommands::give(Command command) noexcept {
  const Tag tag{Source::kPendant, kFirstTag + ++count_ % kTags};
  std::visit(
      [tag](auto& content) {
        if constexpr (requires { content.tag = tag; }) content.tag = tag;
      },
      command);
  if (!inbox_.try_push(command)) return Answer{.status = Status::kBusy};
  given_ = true;
  if (!awaited_) tag_ = tag;
  return std::nullopt;
}

void ArmCommands::on_event(const Event& event) noexcept {
  std::visit(
      Overloaded{[this](const MoveStarted& move) { on_start(move.tag); },
                 [this](const HomingStarted& axis) { on_start(axis.tag); },
                 [this](const IoDone& io) { on_start(io.tag); },
                 [this](const MoveRefused& move) {
                   if (!awaits(move.tag)) return;
                   const bool switches_on = awaited_ == Opcode::kServo && !arm_.drives_on();
                   answer_ = switches_on ? Answer{.status = Status::kAlarm} : Answer{status_of(move.reason), move.axis};
                 },
                 [this](const Faulted& fault) {
                   if (awaited_ == Opcode::kServo && fault.cause == FaultCause::kDrivesOff) answer_ = Answer{};
                 },
                 [this](const FaultCleared&) {
                   if (awaited_ == Opcode::kServo) answer_ = Answer{};
                 },
                 [](const auto&) {}},
      event);
}

void ArmCommands::on_start(Tag tag) noexcept {
  if (awaits(tag)) answer_ = Answer{};
}

}  // namespace armature::pendant
