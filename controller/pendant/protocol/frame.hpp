// A frame of the pendant's line, and its eight bytes. PROTOCOL.md explains the layout.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "controller/pendant/protocol/frame_table.hpp"

namespace armature::pendant {

inline constexpr std::size_t kFrameBytes = 8;
using FrameBytes = std::array<std::uint8_t, kFrameBytes>;

inline constexpr std::uint8_t kSequences = 16;  // sequence numbers are modulo this
inline constexpr std::int32_t kLargestPayload = (1 << 27) - 1;

[[nodiscard]] constexpr std::uint8_t after(std::uint8_t sequence) noexcept {
  return static_cast<std::uint8_t>((sequence + 1u) % kSequences);
}

// A command, a reply or a page of telemetry.
struct Frame {
  Kind kind = Kind::kCommand;  // not kBulk
  std::uint8_t sequence = 0;
  Opcode opcode{};
  std::uint8_t parameter = 0;  // of a reply: the Status
  std::int32_t payload = 0;    // at most kLargestPayload in both directions

  [[nodiscard]] constexpr Status status() const noexcept { return static_cast<Status>(parameter); }
  friend constexpr bool operator==(const Frame&, const Frame&) noexcept = default;
};

// A piece of a program.
struct BulkFrame {
  static constexpr std::size_t kCharacters = 6;
  std::uint8_t sequence = 0;
  std::array<std::uint8_t, kCharacters> text{};  // each below 128

  friend constexpr bool operator==(const BulkFrame&, const BulkFrame&) noexcept = default;
};

[[nodiscard]] FrameBytes encode(const Frame& frame) noexcept;
[[nodiscard]] FrameBytes encode(const BulkFrame& frame) noexcept;

// The two ends of the line; each accepts the frames of the other one only.
enum class End : std::uint8_t { kController, kPendant };

// True for a frame that `end` may receive.
[[nodiscard]] bool valid(std::span<const std::uint8_t, kFrameBytes> bytes, End end) noexcept;

// Of valid bytes.
[[nodiscard]] Kind kind_of(const FrameBytes& bytes) noexcept;
[[nodiscard]] Frame decode(const FrameBytes& bytes) noexcept;           // not of kBulk
[[nodiscard]] BulkFrame decode_bulk(const FrameBytes& bytes) noexcept;  // of kBulk

// The rule of an opcode in the table; nullptr when there is none.
[[nodiscard]] const OpcodeRule* find_rule(std::uint8_t code) noexcept;

}  // namespace armature::pendant
