// Why a controller has not started, as a sentence.
#pragma once

#include <string>

#include "controller/host_memory/memory.hpp"

namespace armature::cosim {

// Names the block and the value that is wrong: `robot.axes[2].gear_ratio`.
[[nodiscard]] std::string boot_text(const host_memory::BootReport& report);

}  // namespace armature::cosim
