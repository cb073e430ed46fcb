// The programmable logic as verilated RTL (rtl/soc/arm_soc.sv).
#pragma once

#include <memory>

#include "cosim/fabric/fabric.hpp"

namespace armature::cosim {

// The logic after its reset sequence, at cycle 0. An assertion of the RTL that fails prints its message and makes
// run() throw RtlAssertionFailed.
[[nodiscard]] std::unique_ptr<Fabric> make_verilated_fabric();

struct RtlAssertionFailed {
  Cycles cycle;
};

}  // namespace armature::cosim
