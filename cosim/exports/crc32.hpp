// The check sum of ZIP and MCAP files: CRC-32 of ISO 3309, as in ITU-T V.42.
#pragma once

#include <boost/crc.hpp>
#include <cstdint>
#include <string_view>

namespace armature::cosim {

[[nodiscard]] inline std::uint32_t crc32(std::string_view bytes) {
  boost::crc_32_type sum;
  sum.process_bytes(bytes.data(), bytes.size());
  return sum.checksum();
}

}  // namespace armature::cosim
