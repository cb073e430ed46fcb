// The frame in which the program of a scenario gives its positions, for pictures and for other programs.
#pragma once

#include <optional>
#include <string>

#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

// The name of a [[frame]], or "base". Of a robot program: that of the first positions of its main job. Nothing if the
// scenario has no program of its own, or if the positions of that job are angles.
[[nodiscard]] std::optional<std::string> program_frame(const Scenario& scenario);

}  // namespace armature::cosim
