#include "tests/bench/bare_model.hpp"

#include <Varm_soc.h>
#include <verilated.h>
#include <Varm_soc_direct.hpp>

#include <memory>
#include <stdexcept>

#include "cosim/fabric/direct_eval.hpp"
#include "cosim/fabric/fabric_wrapper.hpp"
#include "cosim/fabric/gated_clocks.hpp"
#include "cosim/fabric/model_bus.hpp"
#include "cosim/fabric/model_pins.hpp"
#include "cosim/fabric/verilated_fabric.hpp"
#include "cosim/kernel/simulation.hpp"
#include "cosim/soc/pin_soc.hpp"
#include "tests/support/silent_listener.hpp"

namespace armature::bench {

using namespace cosim;

// Forwards to the verilated logic and records what reaches it.
class BareModel::Recorder final : public FabricWrapper {
 public:
  explicit Recorder(BareModel& record) : FabricWrapper{make_verilated_fabric()}, record_{record} {}

  void set_inputs(const SocInputs& inputs) override {
    inner().set_inputs(inputs);
    if (inputs == inputs_ && !stretches().empty()) return;
    inputs_ = inputs;
    next_.new_inputs = true;
  }
  void set_master(const AxiMasterPins& pins) override {
    inner().set_master(pins);
    master_ = pins;
    next_.new_master = true;
  }
  bool run(std::int64_t limit) override {
    const Cycles before = inner().cycle();
    const bool changed = inner().run(limit);
    next_.clocks = static_cast<std::int32_t>((inner().cycle() - before).value());
    next_.outputs = inner().outputs();
    if (next_.new_inputs) record_.inputs_.push_back(inputs_);
    if (next_.new_master) record_.master_.push_back(master_);
    record_.clocks_ += next_.clocks;
    stretches().push_back(next_);
    next_ = {};
    return changed;
  }
  void open_wave(const std::filesystem::path&, WaveFormat) override {}
  void close_wave() override {}

 private:
  std::vector<Stretch>& stretches() { return record_.stretches_; }

  BareModel& record_;
  SocInputs inputs_;
  AxiMasterPins master_;
  Stretch next_;
};

BareModel::BareModel(const Scenario& scenario) {
  cosim::test::SilentListener listener;
  const SimulationEnd end = cosim::test::run_to_end(Simulation{
      scenario, std::make_unique<PinSoc>(std::make_unique<Recorder>(*this), scenario.bus, scenario.seed), listener});
  if (end.reason != EndReason::kFinished) throw std::runtime_error{scenario.name + ": " + end.failure};
  replay([](const Varm_soc& model, const Stretch& stretch) {
    if (sample_pins(model) != stretch.outputs) throw std::runtime_error{"the replay of a run has other outputs"};
  });
}

template <class After>
void BareModel::replay(After after) const {
  VerilatedContext context;
  Varm_soc model{&context};
  drive_pins(model, SocInputs{});
  drive_bus(model, AxiMasterPins{});
  reset(model);
  const SocInputs* inputs = inputs_.data();
  const AxiMasterPins* master = master_.data();
  for (const Stretch& stretch : stretches_) {
    if (stretch.new_inputs) drive_pins(model, *inputs++);
    if (stretch.new_master) drive_bus(model, *master++);
    for (std::int32_t i = 0; i < stretch.clocks; ++i) evaluate_edge(model, needed_clocks(model));
    after(model, stretch);
  }
}

void BareModel::replay() const {
  replay([](const Varm_soc&, const Stretch&) {});
}

}  // namespace armature::bench
