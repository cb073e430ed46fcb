// The pages of the telemetry.
#include <algorithm>
#include <cstddef>

#include "controller/pendant/message_pages.hpp"
#include "controller/pendant/pendant_client.hpp"

namespace armature::pendant {

// The names of Page::kProgram are those of ProgramClient::State.
static_assert(kProgramNames.size() == static_cast<std::size_t>(ProgramClient::State::kAborted) + 1);
static_assert(kMostMessageText >= ProgramNoted::kMostText);

namespace {

MessageKind kind_of(ProgramNote::Kind kind) noexcept {
  switch (kind) {
    case ProgramNote::Kind::kMessage:
      return MessageKind::kMessage;
    case ProgramNote::Kind::kAlarm:
      return MessageKind::kAlarm;
    case ProgramNote::Kind::kStopped:
      return MessageKind::kStopped;
    default:
      return MessageKind::kNone;
  }
}

}  // namespace

void PendantClient::send_telemetry() noexcept {
  if (period_ == Cycles{0} || now_ < telemetry_at_) return;
  telemetry_at_ = now_ + period_;
  const auto selected = std::ranges::count_if(kPageGroups, [this](auto group) { return (pages_ & group) != 0; });
  if (!line_.has_room(static_cast<std::size_t>(selected))) return;
  for (std::uint8_t number = 0; number < kPages; ++number) {
    if ((pages_ & kPageGroups[number]) == 0) continue;
    line_.send(encode(Frame{.kind = Kind::kTelemetry,
                            .sequence = telemetry_sequence_,
                            .opcode = Opcode::kGetStatus,
                            .parameter = number,
                            .payload = page(number)}));
    telemetry_sequence_ = after(telemetry_sequence_);
  }
}

std::int32_t PendantClient::page(std::uint8_t number) const noexcept {
  constexpr auto kJoint = static_cast<std::uint8_t>(Page::kJoint), kLine = static_cast<std::uint8_t>(Page::kLine),
                 kTool = static_cast<std::uint8_t>(Page::kTool), kAlarm = static_cast<std::uint8_t>(Page::kAlarm);
  if (number < kJoint) {
    return kStateState.with(static_cast<std::int32_t>(state())) +
           kStateCoordinates.with(static_cast<std::int32_t>(coordinates_.system())) +
           kStateDrivesOn.with(arm_facts_.servo_on ? 1 : 0) +
           kStateExtended.with(config_.profile == Profile::kExtended ? 1 : 0);
  }
  if (number < kLine) return coordinates_.pulses(number - std::size_t{kJoint}, position_.actual());
  if (number == kLine) return static_cast<std::int32_t>(program_.place());
  if (number < kAlarm) return coordinates_.tool(position_.actual())[number - std::size_t{kTool}];
  if (number == kAlarm) return alarm_;
  if (number == static_cast<std::uint8_t>(Page::kProgram)) return static_cast<std::int32_t>(program_.state());
  return message_page(number);
}

std::int32_t PendantClient::message_page(std::uint8_t number) const noexcept {
  const ProgramNote& note = program_.last_note();
  const std::string_view text = note.text.view();
  if (number == static_cast<std::uint8_t>(Page::kMessage)) {
    return page_of({.number = static_cast<std::uint16_t>(program_.notes()),
                    .kind = kind_of(note.kind),
                    .length = static_cast<std::uint8_t>(text.size())});
  }
  if (number == static_cast<std::uint8_t>(Page::kMessageLine)) return static_cast<std::int32_t>(note.place);
  return text_page(text, number - static_cast<std::size_t>(Page::kMessageText));
}

}  // namespace armature::pendant
