// The end of a register access, and its words in files and messages.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace armature::cosim {

// Named by kBusErrorNames, in this order.
enum class BusError : std::uint8_t {
  kNone,
  kSlaveError,   // the block refused the access, or the crossbar answered in its place
  kDecodeError,  // no block has the address
  kTimeout,      // no answer
};
inline constexpr std::array<std::string_view, 4> kBusErrorNames{"none", "SLVERR", "DECERR", "TIMEOUT"};

[[nodiscard]] constexpr std::string_view bus_error_name(BusError error) {
  return kBusErrorNames[static_cast<std::size_t>(error)];
}
static_assert(bus_error_name(BusError::kTimeout) == "TIMEOUT");

}  // namespace armature::cosim
