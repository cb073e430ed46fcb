// What each command of the pendant does.
#pragma once

#include <optional>

#include "controller/base/units.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/pendant/client/pendant_parts.hpp"
#include "controller/pendant/protocol/answer.hpp"
#include "controller/pendant/protocol/frame.hpp"

namespace armature::pendant {

// Executes a command that admission() admits. None: an event will answer it.
[[nodiscard]] std::optional<Answer> execute_command(const Frame& command, PendantParts& parts, RegisterBus& bus,
                                                    Cycles now) noexcept;

}  // namespace armature::pendant
