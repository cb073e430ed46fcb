// A fault as reports show it, made from the entry of its kind (tables/fault_kinds.hpp).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cosim/fault/fault_spec.hpp"
#include "cosim/scenario/keys/key_value.hpp"

namespace armature::cosim {

// `pulse_loss`
[[nodiscard]] std::string_view fault_kind_name(const FaultKind& kind);

// `pulse_loss of axis 3, 500 pulses`
[[nodiscard]] std::string fault_text(const FaultSpec& fault);

// The keys that only faults of this kind have, with their values, in the order of KEYS.md.
[[nodiscard]] std::vector<NamedValue> fault_parameters(const FaultKind& kind);

}  // namespace armature::cosim
