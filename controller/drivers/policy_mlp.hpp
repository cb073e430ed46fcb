// The multi-layer perceptron of the logic: a network of 8-bit integers with a fixed latency and bounded outputs.
//
// Image, arithmetic and guards: rtl/policy_mlp/README.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "controller/hal/register_bus.hpp"
#include "controller/regs/soc_map.hpp"

namespace armature {

class PolicyMlp {
 public:
  static constexpr std::size_t kInputs = 32;
  static constexpr std::size_t kOutputs = 8;
  static constexpr std::size_t kMemoryWords = 4096;

  explicit PolicyMlp(RegisterBus& bus, RegAddr base = {regs::soc::kPolicyMlpBase}) noexcept : bus_{bus}, base_{base} {}

  // True when the block is present, with 8 lanes and the register map that this driver supports.
  [[nodiscard]] bool identified() noexcept;

  // At most kMemoryWords words. `crc`: the CRC-32 of what a run reads of them. No effect while busy.
  void load(std::span<const std::uint32_t> image, std::uint32_t crc) noexcept;
  // The same in parts: from the first word on; the next words; the checksum.
  void begin_load() noexcept;
  void load_next(std::span<const std::uint32_t> words) noexcept;
  void end_load(std::uint32_t crc) noexcept;
  // The largest magnitude of an output, 0..127; at once.
  void set_bound(std::uint8_t bound) noexcept;

  // Whole words are written: up to three inputs behind the given ones become 0, the others keep their values.
  void set_inputs(std::span<const std::int8_t> inputs) noexcept;
  // No effect while busy.
  void start() noexcept;

  struct Status {
    bool busy = false;
    bool done = false;       // there are outputs
    bool refused = false;    // a start or data came while busy
    bool corrupt = false;    // the image did not have its CRC
    bool malformed = false;  // the image had no end
  };
  [[nodiscard]] Status status() noexcept;
  // 0 unless done.
  [[nodiscard]] std::array<std::int8_t, kOutputs> outputs() noexcept;
  [[nodiscard]] std::uint32_t cycles() noexcept;  // clocks of the last run

 private:
  RegisterBus& bus_;
  RegAddr base_;
};

}  // namespace armature
