// controller.elf of controller/board, which the build embeds.
#pragma once

#include <cstdint>
#include <span>

namespace armature::cosim::iss {

[[nodiscard]] std::span<const std::uint8_t> firmware();

}  // namespace armature::cosim::iss
