// Random frames of the pendant's line.
#pragma once

#include <cstdint>
#include <vector>

#include "controller/pendant/protocol/frame.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::pendant::test {

// A command with any opcode of the table, in the ranges of its parameter and of a payload.
inline Frame random_command(armature::test::SplitMix& random) {
  const OpcodeRule* rule = nullptr;
  do {
    rule = &kOpcodeRules[random.below(static_cast<std::uint32_t>(kOpcodeRules.size()))];
  } while (rule->reply_only);
  const std::uint32_t parameters = 1u + rule->parameter.max - rule->parameter.min;
  constexpr std::uint32_t kPayloads = 2u * static_cast<std::uint32_t>(kLargestPayload) + 1u;
  return {.kind = Kind::kCommand,
          .sequence = static_cast<std::uint8_t>(random.below(kSequences)),
          .opcode = rule->opcode,
          .parameter = static_cast<std::uint8_t>(rule->parameter.min + random.below(parameters)),
          .payload = static_cast<std::int32_t>(random.below(kPayloads)) - kLargestPayload};
}

inline BulkFrame random_bulk(armature::test::SplitMix& random) {
  BulkFrame frame{.sequence = static_cast<std::uint8_t>(random.below(kSequences))};
  for (std::uint8_t& character : frame.text) character = static_cast<std::uint8_t>(random.below(128));
  return frame;
}

// Three of four are commands.
inline FrameBytes random_frame(armature::test::SplitMix& random) {
  return random.below(4) == 0 ? encode(random_bulk(random)) : encode(random_command(random));
}

inline std::vector<std::uint8_t> stream_of(const std::vector<FrameBytes>& frames) {
  std::vector<std::uint8_t> bytes;
  for (const FrameBytes& frame : frames) bytes.insert(bytes.end(), frame.begin(), frame.end());
  return bytes;
}

}  // namespace armature::pendant::test
