// The pages of the telemetry.
#include <array>
#include <cstddef>

#include "controller/pendant/pendant_client.hpp"

namespace armature::pendant {

// The names of Page::kProgram are those of ProgramClient::State.
static_assert(kProgramNames.size() == static_cast<std::size_t>(ProgramClient::State::kAborted) + 1);

void PendantClient::send_telemetry() noexcept {
  struct Group {
    std::uint8_t bit, first, last;  // bit of the parameter of set_telemetry
  };
  constexpr std::array<Group, 6> kGroups{{{0, 0, 0}, {1, 1, 6}, {2, 7, 7}, {3, 8, 13}, {4, 14, 14}, {2, 15, 15}}};
  if (period_ == Cycles{0} || now_ < telemetry_at_) return;
  telemetry_at_ = now_ + period_;
  if (!line_.has_room(kPages)) return;
  for (const Group& group : kGroups) {
    if ((pages_ >> group.bit & 1u) == 0) continue;
    for (std::uint8_t number = group.first; number <= group.last; ++number) {
      line_.send(encode(Frame{.kind = Kind::kTelemetry,
                              .sequence = telemetry_sequence_,
                              .opcode = Opcode::kGetStatus,
                              .parameter = number,
                              .payload = page(number)}));
      telemetry_sequence_ = after(telemetry_sequence_);
    }
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
  return number == kAlarm ? alarm_ : static_cast<std::int32_t>(program_.state());
}

}  // namespace armature::pendant
