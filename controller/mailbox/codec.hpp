// Converts commands and events to the blocks in the rings of the mailbox memory, and back.
#pragma once

#include <optional>

#include "controller/command/command.hpp"
#include "controller/event/event.hpp"
#include "controller/mailbox/command_blocks.hpp"
#include "controller/mailbox/event_blocks.hpp"

namespace armature::mailbox {

[[nodiscard]] CommandBlock encode(const Command& command) noexcept;
[[nodiscard]] EventBlock encode(const Event& event) noexcept;

// Returns nothing for an unknown kind. Values of enumerations are not checked: both sides must have the same layout
// version.
[[nodiscard]] std::optional<Command> decode(const CommandBlock& block) noexcept;
[[nodiscard]] std::optional<Event> decode(const EventBlock& block) noexcept;

}  // namespace armature::mailbox
