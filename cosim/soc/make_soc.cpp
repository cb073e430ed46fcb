#include "cosim/soc/make_soc.hpp"

#include <array>
#include <cstddef>
#include <utility>

#include "controller/base/words.hpp"
#include "cosim/fabric/jittery_fabric.hpp"
#include "cosim/fabric/verilated_fabric.hpp"
#include "cosim/soc/pin_soc.hpp"

namespace armature::cosim {
namespace {

using Maker = std::unique_ptr<Soc> (*)(Variant variant, const BusSpec& bus, std::uint64_t seed, bool input_jitter);

std::unique_ptr<Soc> make_rtl(Variant variant, const BusSpec& bus, std::uint64_t seed, bool input_jitter) {
  std::unique_ptr<Fabric> fabric = make_verilated_fabric(variant);
  if (input_jitter) fabric = with_input_jitter(std::move(fabric), seed);
  return std::make_unique<PinSoc>(std::move(fabric), bus, seed);
}

// In the order of Engine.
constexpr std::array<Maker, kWordsOf<Engine>.size()> kMakers{make_rtl};
static_assert(kMakers.back() != nullptr);

}  // namespace

std::unique_ptr<Soc> make_soc(Variant variant, Engine engine, const BusSpec& bus, std::uint64_t seed,
                              bool input_jitter) {
  return kMakers[static_cast<std::size_t>(engine)](variant, bus, seed, input_jitter);
}

}  // namespace armature::cosim
