#include "cosim/kernel/scenario_soc.hpp"

#include "cosim/engine/make_soc.hpp"

namespace armature::cosim {

std::unique_ptr<Soc> make_soc(const Scenario& scenario) {
  return make_soc(scenario.variant, scenario.engine, scenario.bus, scenario.seed, scenario.input_jitter);
}

}  // namespace armature::cosim
