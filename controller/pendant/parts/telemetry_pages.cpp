#include "controller/pendant/parts/telemetry_pages.hpp"

#include <algorithm>
#include <cstddef>

#include "controller/base/timebase.hpp"
#include "controller/pendant/protocol/frame.hpp"
#include "controller/pendant/protocol/message_pages.hpp"

namespace armature::pendant {

// The names of Page::kProgram are those of ProgramClient::State.
static_assert(kProgramNames.size() == static_cast<std::size_t>(ProgramClient::State::kAborted) + 1);
static_assert(kMaxMessageText >= ProgramNoted::kMaxText);

namespace {

constexpr std::int32_t kShortestPeriod = 20;  // ms

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

void TelemetryPages::select(std::uint8_t groups, std::int32_t period_ms, Cycles now) noexcept {
  groups_ = groups;
  period_ = period_ms < kShortestPeriod ? Cycles{0} : Cycles{period_ms * kClkFreqHz / 1'000};
  next_at_ = now;
}

void TelemetryPages::send_when_due(PendantLine& line, Cycles now) noexcept {
  if (!periodic() || now < next_at_) return;
  next_at_ = now + period_;
  const auto selected = std::ranges::count_if(kPageGroups, [this](auto group) { return (groups_ & group) != 0; });
  if (!line.has_room(static_cast<std::size_t>(selected))) return;
  for (std::uint8_t page = 0; page < kPages; ++page) {
    if ((groups_ & kPageGroups[page]) == 0) continue;
    line.send(encode(Frame{.kind = Kind::kTelemetry,
                           .sequence = sequence_,
                           .opcode = Opcode::kGetStatus,
                           .parameter = page,
                           .payload = value(page, now)}));
    sequence_ = after(sequence_);
  }
}

std::int32_t TelemetryPages::value(std::uint8_t page, Cycles now) const noexcept {
  constexpr auto kJoint = static_cast<std::uint8_t>(Page::kJoint), kLine = static_cast<std::uint8_t>(Page::kLine),
                 kTool = static_cast<std::uint8_t>(Page::kTool), kAlarm = static_cast<std::uint8_t>(Page::kAlarm);
  const auto& [profile, arm, coordinates, position, program] = shown_;
  if (page < kJoint) {
    return kStateState.with(static_cast<std::int32_t>(arm.state(now))) +
           kStateCoordinates.with(static_cast<std::int32_t>(coordinates.system())) +
           kStateDrivesOn.with(arm.drives_on() ? 1 : 0) + kStateExtended.with(profile == Profile::kExtended ? 1 : 0);
  }
  if (page < kLine) return coordinates.pulses(page - std::size_t{kJoint}, position.actual());
  if (page == kLine) return static_cast<std::int32_t>(program.place());
  if (page < kAlarm) return coordinates.tool(position.actual())[page - std::size_t{kTool}];
  if (page == kAlarm) return arm.alarm();
  if (page == static_cast<std::uint8_t>(Page::kProgram)) return static_cast<std::int32_t>(program.state());
  return message(page);
}

std::int32_t TelemetryPages::message(std::uint8_t page) const noexcept {
  const ProgramNote& note = shown_.program.last_note();
  const std::string_view text = note.text.view();
  if (page == static_cast<std::uint8_t>(Page::kMessage)) {
    return page_of({.number = static_cast<std::uint16_t>(shown_.program.notes()),
                    .kind = kind_of(note.kind),
                    .length = static_cast<std::uint8_t>(text.size())});
  }
  if (page == static_cast<std::uint8_t>(Page::kMessageLine)) return static_cast<std::int32_t>(note.place);
  return text_page(text, page - static_cast<std::size_t>(Page::kMessageText));
}

}  // namespace armature::pendant
