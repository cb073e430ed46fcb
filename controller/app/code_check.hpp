// Compares the code of the firmware, and its constants, with what they were at the start.
//
// After a flipped bit in the code a core computes something else, and nothing computes it a second time. Core 1 sums up
// one part of eight each time when core 0 asks whether it still executes (LoopChannel::question, twenty times a
// second). So a changed word is found within 0.4 s. A debugger that writes breakpoints into the memory changes the
// code, too.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "controller/command/core1_client.hpp"
#include "controller/motion/loop_channel.hpp"

namespace armature {

class CodeCheck final : public Core1Client {
 public:
  static constexpr std::size_t kParts = 8;

  // Sums up the code. Empty code, as that of a simulation, is never checked. The memory and the channel must outlive
  // the check.
  CodeCheck(std::span<const std::uint32_t> code, LoopChannel& channel) noexcept;

  // If core 0 has asked since the last call: sums up the next part, and reports a change to core 0.
  [[nodiscard]] bool execute(RegisterBus&) noexcept override;

 private:
  // Fletcher's sums: of the words, and of these sums.
  struct Sums {
    std::uint32_t words = 0, sums = 0;
    friend bool operator==(const Sums&, const Sums&) = default;
  };
  [[nodiscard]] Sums sums_of(std::size_t part) const noexcept;

  std::span<const std::uint32_t> code_;
  LoopChannel& channel_;
  std::array<Sums, kParts> at_start_{};
  std::size_t next_ = 0;
  std::uint32_t answered_ = LoopChannel::kNotStarted;
};

}  // namespace armature
