// The programmable logic as a model: an independent description of every block, computed from event to event.
//
// It is a Fabric, clock for clock: its output pins and its bus are those of the verilated RTL after every edge
// (`--engine lockstep` compares both). Waveforms have the pins and the signals of the software.
#pragma once

#include <memory>

#include "cosim/fabric/fabric.hpp"
#include "cosim/logic/logic_spec.hpp"

namespace armature::cosim::model {

// The logic at cycle 0.
[[nodiscard]] std::unique_ptr<Fabric> make_model_fabric(Variant variant);

}  // namespace armature::cosim::model
