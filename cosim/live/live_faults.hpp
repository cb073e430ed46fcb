// The faults that a live page can cause: all kinds of [[fault]], made from their entries in cosim/scenario/tables.
#pragma once

#include "cosim/fault/fault_spec.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/scenario/toml/config_value.hpp"
#include "cosim/text/json.hpp"

namespace armature::cosim {

// [{"kind", "text", "keys": [{"key", "text", "unit", "min", "max", "choices", "whole", "value"}]}]. `choices` is null
// for a number. `value`: a value that shows the fault.
[[nodiscard]] Json fault_kinds_json(const RobotSpec& robot);

// The fault of a table that has the keys of [[fault]] without `at_s`. It begins at `now`. Throws MessageError.
[[nodiscard]] FaultSpec read_fault(ConfigValue table, const Scenario& scenario, Cycles now);

}  // namespace armature::cosim
