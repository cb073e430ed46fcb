// The programmable logic as verilated RTL (rtl/soc/arm_soc.sv), in either of its variants.
#pragma once

#include <memory>

#include "cosim/fabric/fabric.hpp"
#include "cosim/logic/logic_spec.hpp"

namespace armature::cosim {

// The logic after its reset sequence, at cycle 0. Variant::kPaper is PaperFabric = 1 of arm_soc.
[[nodiscard]] std::unique_ptr<Fabric> make_verilated_fabric(Variant variant = Variant::kCounts);

}  // namespace armature::cosim
