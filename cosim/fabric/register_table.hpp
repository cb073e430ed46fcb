// The names of the registers by their addresses.
#pragma once

#include <cstdint>
#include <string>

#include "cosim/logic/logic_spec.hpp"

namespace armature::cosim {

// `pulse_train.count[2]` for the word that is accessed at `address`; empty if the variant has no register there.
[[nodiscard]] std::string register_name(Variant variant, std::uint32_t address);

}  // namespace armature::cosim
