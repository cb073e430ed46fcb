// The outputs and inputs of a block: M62 to M68.
#pragma once

#include "controller/language/gcode/canon/line_calls.hpp"
#include "controller/language/gcode/reader/block.hpp"

namespace armature::gcode {

[[nodiscard]] Failure set_outputs(const Block& block, LineCalls& calls) noexcept;

// Whether the program continues when it has the value of an input: M66.
[[nodiscard]] inline bool waits_for_input(const Block& block) noexcept {
  return block.is(Group::kOutputs, 660);
}

}  // namespace armature::gcode
