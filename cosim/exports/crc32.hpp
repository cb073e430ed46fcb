// The check sum of ZIP and MCAP files: CRC-32 of ISO 3309, as in ITU-T V.42.
#pragma once

#include <cstdint>
#include <string_view>

namespace armature::cosim {

// Of bytes that continue those of which `before` is the check sum; 0: none.
[[nodiscard]] std::uint32_t crc32(std::string_view bytes, std::uint32_t before = 0);

}  // namespace armature::cosim
