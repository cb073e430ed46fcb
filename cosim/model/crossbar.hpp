// The crossbar: one AXI4-Lite port of the master, one port for each block (rtl/axi/README.md).
//
// Writes and reads are independent and have one transaction in flight each. A request is held from its handshake until
// its response has been accepted. It reaches its block two edges after the handshake, and the response takes one edge
// back. An address without a block is answered DECERR. A block that does not answer within kTimeout edges, or shows a
// response before it has accepted the request, is answered SLVERR, and so is every later request for it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "cosim/fabric/fabric.hpp"
#include "cosim/model/block.hpp"

namespace armature::cosim::model {

// The port that claims an address, if one does. `bases`: of the blocks, in the order of their ports.
[[nodiscard]] inline std::optional<std::size_t> port_of(std::uint32_t address, std::span<const std::uint32_t> bases) {
  constexpr std::uint32_t kBlockMask = 0xFFFF'0000;  // each block has 64 KiB
  for (std::size_t port = 0; port < bases.size(); ++port) {
    if ((address & kBlockMask) == bases[port]) return port;
  }
  return std::nullopt;
}

class Crossbar {
 public:
  static constexpr Cycles kTimeout{128};

  // `bases` must outlive the crossbar.
  explicit Crossbar(std::span<const std::uint32_t> bases) : bases_{bases} {}

  // The edge `at`. `in`: the master before it. `blocks`: the ports of the blocks before it.
  void edge(Cycles at, const AxiMasterPins& in, std::span<const AxiSlavePins* const> blocks);

  // Whether the coming edge changes the crossbar.
  [[nodiscard]] bool is_active(const AxiMasterPins& in) const {
    return in.awvalid || in.wvalid || in.arvalid || !pins_.awready || !pins_.wready || !pins_.arready;
  }
  [[nodiscard]] const AxiSlavePins& pins() const { return pins_; }

  // The port whose block has a request or response of this direction; none: no block has one.
  [[nodiscard]] std::optional<std::size_t> write_port() const { return write_.port(); }
  [[nodiscard]] std::optional<std::size_t> read_port() const { return read_.port(); }
  // What that block sees. A block that is neither port sees an idle bus.
  [[nodiscard]] AxiMasterPins to_block(std::size_t port) const;

 private:
  // What both directions have in common.
  struct Path {
    bool forwarded = false;             // or answered in the place of a block
    bool waits = false;                 // for the response of the block `target`
    std::optional<std::size_t> target;  // the port that claims the address
    Cycles sent_at{};
    std::uint32_t hung = 0;  // ports that were given up

    [[nodiscard]] std::optional<std::size_t> port() const { return waits ? target : std::nullopt; }
  };

  void write_edge(Cycles at, const AxiMasterPins& in, std::span<const AxiSlavePins* const> blocks, std::uint32_t hung);
  // While the block has a write request: its response, or an error in the place of the block.
  void take_write_response(Cycles at, const AxiSlavePins& block);
  void read_edge(Cycles at, const AxiMasterPins& in, std::span<const AxiSlavePins* const> blocks, std::uint32_t hung);
  // Forwards the held request. Returns the response when no block gets it.
  [[nodiscard]] static std::optional<std::uint8_t> forward(Path& path, Cycles at, std::uint32_t hung);

  std::span<const std::uint32_t> bases_;
  AxiSlavePins pins_{.awready = true, .wready = true, .arready = true};
  Path write_, read_;
  AxiMasterPins held_;  // address, data and strobes of the held requests; VALID towards the block
};

}  // namespace armature::cosim::model
