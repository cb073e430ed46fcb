#include "controller/pendant/protocol/admission.hpp"

#include <cstddef>

namespace armature::pendant {
namespace {

bool listed(std::uint16_t states, State state) {
  return ((states >> static_cast<unsigned>(state)) & 1u) != 0;
}

}  // namespace

Status admission(const Frame& command, State state, Profile profile) noexcept {
  const OpcodeRule* rule = find_rule(static_cast<std::uint8_t>(command.opcode));
  if (rule == nullptr || rule->reply_only) return Status::kUnknown;
  const unsigned extended = profile == Profile::kExtended ? rule->extended : 0u;
  const auto states = static_cast<std::uint16_t>(rule->states | extended);
  if (!listed(states, state)) {
    // Switching on the drives would not help.
    if (state == State::kIdle && !listed(states, State::kReady)) return Status::kMode;
    return kRefusals[static_cast<std::size_t>(state)];
  }
  if (command.payload < rule->payload.min || command.payload > rule->payload.max) return Status::kRange;
  return Status::kOk;
}

}  // namespace armature::pendant
