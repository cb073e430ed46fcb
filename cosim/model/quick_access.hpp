// The times of a register access that nothing disturbs: no stall, no block that hangs, a clock that runs.
//
// Then the handshakes of the bus master and the crossbar are known in advance (rtl/axi/README.md), and only the edge at
// which the block executes the access must be computed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>

#include "cosim/bus/bus_access.hpp"
#include "cosim/bus/bus_spec.hpp"
#include "cosim/model/block.hpp"
#include "cosim/model/crossbar.hpp"

namespace armature::cosim::model {

// What the block sees of it.
[[nodiscard]] inline Strobes strobes_of(const BusRequest& request) {
  const auto offset = static_cast<std::uint16_t>(request.addr);
  if (request.write) return {.write = true, .waddr = offset, .wdata = request.data, .wstrb = request.strobes};
  return {.read = true, .raddr = offset};
}
// What the processor receives from the block.
[[nodiscard]] inline BusResponse response_of(const BusRequest& request, const Answer& answer) {
  if (request.write) return {.error = answer.werr ? BusError::kSlaveError : BusError::kNone};
  return {.error = answer.rerr ? BusError::kSlaveError : BusError::kNone, .data = answer.rdata};
}

struct QuickAccess {
  BusRequest request{};
  std::optional<std::size_t> port{};  // none: no block has the address
  Cycles started{};
  Cycles executed{};  // the edge at which the block executes it
  Cycles ends{};      // the processor receives the response
  Answer answer{};    // from `executed` on

  // The next edge that must be computed for it.
  [[nodiscard]] Cycles next_edge(Cycles now) const { return port && now < executed ? executed : ends; }

  [[nodiscard]] Strobes strobes() const { return strobes_of(request); }
  [[nodiscard]] BusResponse response() const {
    if (!port) return {.error = BusError::kDecodeError};
    return response_of(request, answer);
  }
};

// The times of such accesses over a bus, from their start.
struct QuickTimes {
  Cycles executed{}, write_ends{}, read_ends{}, unclaimed_ends{};

  explicit QuickTimes(const BusSpec& bus) {
    constexpr Cycles kToBlock{3}, kWriteEdges{6}, kReadEdges{5}, kUnclaimedEdges{2};
    // The master drives its pins a clock after the start at the earliest. The crossbar accepts them at the next edge.
    const Cycles accepted{std::max<std::int64_t>(bus.latency_cycles, 1) + 1};
    const Cycles back{bus.latency_cycles};
    executed = accepted + kToBlock;
    write_ends = accepted + kWriteEdges + back;
    read_ends = accepted + kReadEdges + back;
    unclaimed_ends = accepted + kUnclaimedEdges + back;
  }
  // Of an access to a block.
  [[nodiscard]] Cycles ends(bool write) const { return write ? write_ends : read_ends; }
};

// Whether accesses over this bus have those times.
[[nodiscard]] inline bool is_quick(const BusSpec& bus) {
  constexpr std::int64_t kHandshakes = 8;
  return bus.stall_probability == 0.0 && bus.timeout_cycles > bus.latency_cycles + kHandshakes;
}

// An access that starts at `now`. `bases`: of the blocks, by port.
[[nodiscard]] inline QuickAccess quick_access(const BusRequest& request, Cycles now, const QuickTimes& times,
                                              std::span<const std::uint32_t> bases) {
  QuickAccess access{.request = request, .port = port_of(request.addr, bases), .started = now};
  access.executed = now + times.executed;
  access.ends = now + (access.port ? times.ends(request.write) : times.unclaimed_ends);
  return access;
}

}  // namespace armature::cosim::model
