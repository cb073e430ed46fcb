// Two fabrics in lock-step: every output pin and every pin of the bus is compared after each clock edge.
//
// The first one is the reference. Its pins are those of the pair.
#pragma once

#include <memory>

#include "cosim/fabric/fabric.hpp"

namespace armature::cosim {

// Both must be at cycle 0. run() throws EnginesDiffer at the first edge after which a pin differs, and so does this
// function. Waveforms are those of the reference.
[[nodiscard]] std::unique_ptr<Fabric> in_lockstep(std::unique_ptr<Fabric> reference, std::unique_ptr<Fabric> model);

}  // namespace armature::cosim
