// What the entry of its kind (tables/move_kinds.hpp) says about a command.
#pragma once

#include <string>
#include <string_view>

#include "cosim/scenario/moves/kinds.hpp"

namespace armature::cosim {

// `clear_fault`
[[nodiscard]] std::string_view move_kind_name(const CommandKind& kind);

// `override 30 %`
[[nodiscard]] std::string move_text(const CommandKind& kind);

// Whether the command waits in the queue of moves.
[[nodiscard]] bool is_queued(const CommandKind& kind);

}  // namespace armature::cosim
