// The AXI4-Lite slave port of a block: handshakes become accesses of one clock edge (rtl/axi/README.md).
//
// Writes and reads are independent and have one transaction in flight each. AW and W come in any order. READY of a
// channel is low from its handshake until the response has been accepted.
//
//   edge     n              n + 1         n + 2          n + 3
//   write    AW+W accepted  executed                     BVALID is 1 before it
//   read     AR accepted    executed      RVALID is 1 before it
#pragma once

#include "cosim/fabric/fabric.hpp"
#include "cosim/model/block.hpp"

namespace armature::cosim::model {

class BusPort {
 public:
  // The accesses that the block executes at the coming edge.
  [[nodiscard]] const Strobes& strobes() const { return strobes_; }

  // One clock edge. `in`: levels of the master before it. `answer`: of the block, to strobes().
  void edge(const AxiMasterPins& in, const Answer& answer);

  // Levels after the latest edge.
  [[nodiscard]] const AxiSlavePins& pins() const { return pins_; }

  // Whether the coming edge changes the port.
  [[nodiscard]] bool is_active(const AxiMasterPins& in) const {
    return in.awvalid || in.wvalid || in.arvalid || !pins_.awready || !pins_.wready || !pins_.arready;
  }

 private:
  void write_edge(const AxiMasterPins& in, const Answer& answer);
  void read_edge(const AxiMasterPins& in, const Answer& answer);

  AxiSlavePins pins_{.awready = true, .wready = true, .arready = true};
  Strobes strobes_;
  bool executed_ = false;  // the write in flight, at the latest edge; werr_ is its answer
  bool werr_ = false;
};

}  // namespace armature::cosim::model
