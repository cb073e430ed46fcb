#include "cosim/engine/make_soc.hpp"

#include <array>
#include <cstddef>
#include <utility>

#include "controller/base/words.hpp"
#include "cosim/engine/lockstep_fabric.hpp"
#include "cosim/fabric/jittery_fabric.hpp"
#include "cosim/fabric/verilated_fabric.hpp"
#include "cosim/model/model_fabric.hpp"
#include "cosim/model/model_soc.hpp"
#include "cosim/soc/pin_soc.hpp"

namespace armature::cosim {
namespace {

using Maker = std::unique_ptr<Soc> (*)(Variant variant, const BusSpec& bus, std::uint64_t seed, bool input_jitter);

template <auto kFabric>
std::unique_ptr<Soc> make_on_pins(Variant variant, const BusSpec& bus, std::uint64_t seed, bool input_jitter) {
  std::unique_ptr<Fabric> fabric = kFabric(variant);
  if (input_jitter) fabric = with_input_jitter(std::move(fabric), seed);
  return std::make_unique<PinSoc>(std::move(fabric), bus, seed);
}

std::unique_ptr<Soc> make_model(Variant variant, const BusSpec& bus, std::uint64_t seed, bool input_jitter) {
  if (input_jitter) return make_on_pins<model::make_model_fabric>(variant, bus, seed, input_jitter);
  return model::make_model_soc(variant, bus, seed);
}

std::unique_ptr<Fabric> make_lockstep_fabric(Variant variant) {
  return in_lockstep(make_verilated_fabric(variant), model::make_model_fabric(variant));
}

// In the order of Engine.
constexpr std::array<Maker, kWordsOf<Engine>.size()> kMakers{make_on_pins<make_verilated_fabric>, make_model,
                                                             make_on_pins<make_lockstep_fabric>};
static_assert(kMakers.back() != nullptr);

}  // namespace

std::unique_ptr<Soc> make_soc(Variant variant, Engine engine, const BusSpec& bus, std::uint64_t seed,
                              bool input_jitter) {
  return kMakers[static_cast<std::size_t>(engine)](variant, bus, seed, input_jitter);
}

}  // namespace armature::cosim
