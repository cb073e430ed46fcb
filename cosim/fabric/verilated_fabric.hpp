// The programmable logic as verilated RTL (rtl/soc/arm_soc.sv).
#pragma once

#include <memory>

#include "cosim/fabric/fabric.hpp"

namespace armature::cosim {

// The logic after its reset sequence, at cycle 0.
[[nodiscard]] std::unique_ptr<Fabric> make_verilated_fabric();

}  // namespace armature::cosim
