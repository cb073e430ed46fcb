#include "cosim/soc/make_soc.hpp"

#include <array>
#include <cstddef>

#include "cosim/fabric/verilated_fabric.hpp"
#include "cosim/soc/pin_soc.hpp"

namespace armature::cosim {
namespace {

using Maker = std::unique_ptr<Soc> (*)(Variant variant, const BusSpec& bus, std::uint64_t seed);

std::unique_ptr<Soc> make_rtl(Variant variant, const BusSpec& bus, std::uint64_t seed) {
  return std::make_unique<PinSoc>(make_verilated_fabric(variant), bus, seed);
}

// In the order of Engine.
constexpr std::array<Maker, kEngineNames.size()> kMakers{make_rtl};
static_assert(kMakers.back() != nullptr);

}  // namespace

std::unique_ptr<Soc> make_soc(Variant variant, Engine engine, const BusSpec& bus, std::uint64_t seed) {
  return kMakers[static_cast<std::size_t>(engine)](variant, bus, seed);
}

std::unique_ptr<Soc> make_soc(const Scenario& scenario) {
  return make_soc(scenario.variant, scenario.engine, scenario.bus, scenario.seed);
}

}  // namespace armature::cosim
