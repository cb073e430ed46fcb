// The pages of the telemetry.
#include <cstddef>

#include "controller/pendant/pendant_client.hpp"

namespace armature::pendant {

// The names of Page::kProgram are those of ProgramClient::State.
static_assert(kProgramNames.size() == static_cast<std::size_t>(ProgramClient::State::kAborted) + 1);

void PendantClient::send_telemetry() noexcept {
  if (period_ == Cycles{0} || now_ < telemetry_at_) return;
  telemetry_at_ = now_ + period_;
  if (!line_.has_room(kPages)) return;
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
  return number == kAlarm ? alarm_ : static_cast<std::int32_t>(program_.state());
}

}  // namespace armature::pendant
