// What the entry of its kind (tables/move_kinds.hpp) says about a command.
#pragma once

#include <string>

#include "cosim/scenario/moves/kinds.hpp"

namespace armature::cosim {

// `override 30 %`
[[nodiscard]] std::string move_text(const CommandKind& kind);

// Whether the command waits in the queue of moves.
[[nodiscard]] bool is_queued(const CommandKind& kind);

}  // namespace armature::cosim
