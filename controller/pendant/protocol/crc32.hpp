// The check value of a program or of staged targets: CRC-32, modulo 2^26 so that it fits a payload.
#pragma once

#include <cstdint>

#include "controller/base/crc32.hpp"

namespace armature::pendant {

class Crc32 : public armature::Crc32 {
 public:
  static constexpr std::uint32_t kCheckMask = (1u << 26) - 1u;

  [[nodiscard]] constexpr std::int32_t check() const noexcept {
    return static_cast<std::int32_t>(value() & kCheckMask);
  }
};

}  // namespace armature::pendant
