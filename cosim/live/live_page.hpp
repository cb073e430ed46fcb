// The page of `armature live`. It needs no other file and no network but its own WebSocket.
#pragma once

#include <string>

namespace armature::cosim {

// `name`: of the scenario, for the title.
[[nodiscard]] std::string live_page(const std::string& name);

}  // namespace armature::cosim
