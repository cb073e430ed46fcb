// Which bits a sweep flips.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "controller/base/units.hpp"
#include "cosim/cpu/core_memory.hpp"
#include "cosim/fabric/flops/flop.hpp"
#include "cosim/flips/flip.hpp"
#include "cosim/flips/flip_sweep.hpp"

namespace armature::cosim {

// Every K-th bit of the flops of a block, or of all of them if it is empty.
[[nodiscard]] std::vector<Flip> flips_of(const std::vector<Flop>& flops, const std::string& block, std::int64_t every);

// So many random bits of each part of the memory, or of one part.
[[nodiscard]] std::vector<Flip> flips_of(const CoreMemory& memory, const std::string& part, std::int64_t bits,
                                         std::uint64_t seed);

// So many instants, spread over the ticks in which the motors move, up to a time; each at a random clock edge of its
// tick.
[[nodiscard]] std::vector<Cycles> instants_of(const UnflippedRun& run, int count, double until_s, std::uint64_t seed);

}  // namespace armature::cosim
