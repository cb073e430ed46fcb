// The bus of the logic clock for clock: the crossbar and the port of each block.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "cosim/fabric/fabric.hpp"
#include "cosim/model/block.hpp"
#include "cosim/model/bus_port.hpp"
#include "cosim/model/crossbar.hpp"

namespace armature::cosim::model {

template <std::size_t kBlocks>
class Bus {
 public:
  // See Crossbar.
  explicit Bus(const std::array<std::uint32_t, kBlocks>& bases) : crossbar_{bases} {}

  // Whether the coming edge changes the bus. `in`: the master before it.
  [[nodiscard]] bool is_active(const AxiMasterPins& in) const { return crossbar_.is_active(in); }
  [[nodiscard]] const AxiSlavePins& pins() const { return crossbar_.pins(); }

  // The accesses of the coming edge, by port.
  [[nodiscard]] std::array<Strobes, kBlocks> accesses() const {
    std::array<Strobes, kBlocks> accesses;
    for (std::size_t i = 0; i < kBlocks; ++i) {
      if (!is_stopped(i)) accesses[i] = ports_[i].strobes();
    }
    return accesses;
  }

  // The edge `at`. `answers`: of the blocks, to accesses().
  void edge(Cycles at, const AxiMasterPins& in, const std::array<Answer, kBlocks>& answers) {
    std::array<const AxiSlavePins*, kBlocks> blocks;
    for (std::size_t i = 0; i < kBlocks; ++i) blocks[i] = &ports_[i].pins();
    std::array<AxiMasterPins, kBlocks> to_block;
    for (std::size_t i = 0; i < kBlocks; ++i) to_block[i] = crossbar_.to_block(i);
    crossbar_.edge(at, in, blocks);
    for (std::size_t i = 0; i < kBlocks; ++i) {
      if (!is_stopped(i) && ports_[i].is_active(to_block[i])) ports_[i].edge(to_block[i], answers[i]);
    }
  }

  // The ports of these blocks, one bit each, stand still from now on.
  void stop(std::uint32_t ports) { stopped_ |= ports; }

 private:
  [[nodiscard]] bool is_stopped(std::size_t port) const { return (stopped_ >> port & 1u) != 0; }

  Crossbar crossbar_;
  std::array<BusPort, kBlocks> ports_;
  std::uint32_t stopped_ = 0;
};

}  // namespace armature::cosim::model
