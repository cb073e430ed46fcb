// The programmable logic as verilated RTL (rtl/soc/arm_soc.sv), in either of its variants.
#pragma once

#include <cstdint>
#include <memory>

#include "cosim/fabric/fabric.hpp"

namespace armature::cosim {

enum class FabricKind : std::uint8_t {
  kRtl,   // PaperFabric = 0: counts per tick, a decoder per axis
  kPaper  // PaperFabric = 1, as Vo 2021 describes it: half periods, one decoder behind a switch
};

// The logic after its reset sequence, at cycle 0.
[[nodiscard]] std::unique_ptr<Fabric> make_verilated_fabric(FabricKind kind = FabricKind::kRtl);

}  // namespace armature::cosim
