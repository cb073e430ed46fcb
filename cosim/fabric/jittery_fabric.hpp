// The uncertainty of the synchronisers at the input pins: a change may be seen by the first flop one clock edge later.
//
// A level that changes near a clock edge may be sampled as the old one. Each bit that set_inputs() changes reaches the
// logic with the next edge or with the one after it, by a seeded random choice of its own.
#pragma once

#include <cstdint>
#include <memory>

#include "cosim/fabric/fabric.hpp"

namespace armature::cosim {

// `fabric` with that uncertainty. It must be at cycle 0.
[[nodiscard]] std::unique_ptr<Fabric> with_input_jitter(std::unique_ptr<Fabric> fabric, std::uint64_t seed);

}  // namespace armature::cosim
