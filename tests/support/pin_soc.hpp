// A chip around a given logic, with the bus of a scenario that says nothing about it.
#pragma once

#include <memory>
#include <utility>

#include "cosim/soc/pin_soc.hpp"

namespace armature::cosim::test {

inline std::unique_ptr<Soc> pin_soc(std::unique_ptr<Fabric> fabric, const BusSpec& bus = {}, std::uint64_t seed = 1) {
  return std::make_unique<PinSoc>(std::move(fabric), bus, seed);
}

}  // namespace armature::cosim::test
