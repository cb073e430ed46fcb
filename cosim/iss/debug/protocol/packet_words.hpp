// The parts of a packet's text.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "cosim/iss/debug/protocol/target.hpp"

namespace armature::cosim::iss {

// The text after `prefix`. Nothing: the packet is another one.
[[nodiscard]] std::optional<std::string_view> after(std::string_view packet, std::string_view prefix);

// Splits at the first `mark`. The second part is empty if there is none.
[[nodiscard]] std::pair<std::string_view, std::string_view> split(std::string_view text, char mark);

// A number of 32 bits.
[[nodiscard]] std::optional<std::uint32_t> word(std::string_view digits);

// `ADDRESS,BYTES`
struct PacketRange {
  std::uint32_t address = 0, bytes = 0;
};
[[nodiscard]] std::optional<PacketRange> range_of(std::string_view text);

// Thread 1 is core 0. Nothing: it is no thread, or any (0, -1).
[[nodiscard]] std::optional<int> core_of(std::string_view thread);

[[nodiscard]] std::uint64_t little_endian(std::span<const std::uint8_t> bytes);

// Of the digit behind Z and z.
[[nodiscard]] std::optional<StopPoint::Kind> point_kind(char digit);

}  // namespace armature::cosim::iss
