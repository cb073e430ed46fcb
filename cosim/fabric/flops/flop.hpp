// A register of the programmable logic.
#pragma once

#include <string>

namespace armature::cosim {

struct Flop {
  std::string name;  // below the top module, as in waveforms: `u_axi_uart16550.u_core.u_rx_fifo.entry_q[3]`
  int bits = 0;

  friend bool operator==(const Flop&, const Flop&) = default;
};

}  // namespace armature::cosim
