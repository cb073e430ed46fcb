// Creates the chip with the logic and the engine that the user chose. Only make_soc.cpp knows all implementations.
#pragma once

#include <cstdint>
#include <memory>

#include "cosim/bus/bus_spec.hpp"
#include "cosim/logic/logic_spec.hpp"
#include "cosim/soc/soc.hpp"

namespace armature::cosim {

// A chip at cycle 0. `seed` is for the random stalls of `bus` and for `input_jitter`:
// changes of input pins reach the logic up to a clock later.
[[nodiscard]] std::unique_ptr<Soc> make_soc(Variant variant, Engine engine, const BusSpec& bus, std::uint64_t seed,
                                            bool input_jitter = false);

}  // namespace armature::cosim
