// From the user's choice of the logic and of its engine to an implementation. No other place knows which there are.
#pragma once

#include <cstdint>
#include <memory>

#include "cosim/scenario/scenario.hpp"
#include "cosim/soc/soc.hpp"

namespace armature::cosim {

// A chip at cycle 0. `seed` is that of the stalls that `bus` asks for.
[[nodiscard]] std::unique_ptr<Soc> make_soc(Variant variant, Engine engine, const BusSpec& bus, std::uint64_t seed);

// The chip that a scenario asks for.
[[nodiscard]] std::unique_ptr<Soc> make_soc(const Scenario& scenario);

}  // namespace armature::cosim
