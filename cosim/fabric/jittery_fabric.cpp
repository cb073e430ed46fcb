#include "cosim/fabric/jittery_fabric.hpp"

#include <utility>

#include "cosim/fabric/fabric_wrapper.hpp"
#include "cosim/logic/pin_table.hpp"
#include "cosim/time/random.hpp"

namespace armature::cosim {
namespace {

class JitteryFabric final : public FabricWrapper {
 public:
  JitteryFabric(std::unique_ptr<Fabric> fabric, std::uint64_t seed) : FabricWrapper{std::move(fabric)}, random_{seed} {}

  void set_inputs(const SocInputs& inputs) override {
    wanted_ = inputs;
    SocInputs now = inputs;
    for (const Pin& pin : pins()) {
      if (!pin.is_input()) continue;
      const std::uint32_t changed = pin.get(inputs, {}) ^ pin.get(seen_, {});
      if (changed == 0) continue;
      pin.set(now, pin.get(inputs, {}) ^ (changed & static_cast<std::uint32_t>(random_.next() >> 32)));
    }
    apply(now);
  }

  bool run(std::int64_t limit) override {
    if (seen_ == wanted_) return inner().run(limit);
    const bool changed = inner().run(1);
    apply(wanted_);
    return changed || (limit > 1 && inner().run(limit - 1));
  }

 private:
  void apply(const SocInputs& inputs) {
    seen_ = inputs;
    inner().set_inputs(inputs);
  }

  Random random_;
  SocInputs wanted_;  // levels at the pins
  SocInputs seen_;    // levels that the next edge samples
};

}  // namespace

std::unique_ptr<Fabric> with_input_jitter(std::unique_ptr<Fabric> fabric, std::uint64_t seed) {
  return std::make_unique<JitteryFabric>(std::move(fabric), seed);
}

}  // namespace armature::cosim
