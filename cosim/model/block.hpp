// What the models of the blocks have in common: time, register accesses, and when a block must be computed.
//
// A block is synchronous. Its state after the clock edge `at` follows from its state before that edge, from its inputs
// and from the register access at that edge. Each block is a class with these members:
//
//   Answer edge(Cycles at, const Strobes& access, const Inputs& inputs);
//     Computes the clock edge `at`. Inputs: a struct of the block, with the levels before the edge. Edges come in
//     order. An edge may be left out when it has no access, its inputs are those of the latest computed edge, without
//     its trigger (after_trigger()), and it is earlier than wakes_at(). An edge that is computed although it could be
//     left out changes nothing.
//   Cycles wakes_at() const;
//     The next edge that must be computed though nothing changes from outside, later than the latest computed edge;
//     kNever if there is none. So a block stores times of coming events instead of counters that run.
//   Answer access(Cycles at, const Strobes& access, const Inputs& inputs);
//     Optional: edge() for an edge that could be left out but for its access, and at which no output changes.
//   std::optional<std::uint32_t> peek(...) const;
//     Optional: what a read finds that changes nothing; none: it may change something, or is an error.
//   outputs: levels after the latest computed edge. They do not change at edges that are left out.
//
// Edge 1 is the first one after reset: kTimeZero is the state in reset.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "cosim/bus/register_address.hpp"
#include "cosim/time/never.hpp"

namespace armature::cosim::model {

inline constexpr Cycles kTimeZero{0};

// The register accesses of one clock edge. Addresses are in bytes from the base of the block.
struct Strobes {
  bool read = false;
  bool write = false;
  std::uint16_t raddr = 0;
  std::uint16_t waddr = 0;
  std::uint32_t wdata = 0;
  std::uint8_t wstrb = 0;  // bit i: byte i is written

  [[nodiscard]] bool any() const { return read || write; }
};

// The inputs of the edges to come that may be left out, after an edge with these: a trigger is high at single edges.
template <class Inputs>
[[nodiscard]] constexpr Inputs after_trigger(Inputs inputs) {
  if constexpr (requires { inputs.trigger; }) inputs.trigger = false;
  return inputs;
}

// The answer to the accesses of one clock edge. A member without its strobe means nothing.
struct Answer {
  std::uint32_t rdata = 0;
  bool rerr = false;  // SLVERR
  bool werr = false;
};

// What a read of an offset without a register returns, unless the map of the block says otherwise (rtl/REGISTERS.md).
inline constexpr std::uint32_t kUnmappedData = 0xBADACCE5;
inline constexpr Answer kUnmappedRead{.rdata = kUnmappedData, .rerr = true};

// The offset of the word that has the address: bits 1:0 select nothing.
[[nodiscard]] constexpr std::uint32_t word_offset(std::uint16_t address) {
  return address & ~3u;
}

// The element that has this offset, in an array with a register for each axis that begins at `first`; none: no element.
[[nodiscard]] constexpr std::optional<std::size_t> element_at(std::uint32_t offset, std::uint32_t first) {
  return element(offset, first, 4, kAxes);
}

// The bits of the bytes that the access writes.
[[nodiscard]] constexpr std::uint32_t written_bits(const Strobes& access) {
  std::uint32_t mask = 0;
  for (unsigned byte = 0; byte < 4; ++byte) {
    if ((access.wstrb >> byte & 1u) != 0) mask |= 0xFFu << (8 * byte);
  }
  return mask;
}

// The word `old` with the bytes that the access writes.
[[nodiscard]] constexpr std::uint32_t merged(std::uint32_t old, const Strobes& access) {
  const std::uint32_t mask = written_bits(access);
  return (old & ~mask) | (access.wdata & mask);
}

}  // namespace armature::cosim::model
