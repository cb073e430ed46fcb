#include "cosim/engine/lockstep_fabric.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <string_view>
#include <utility>

#include "cosim/fabric/fabric_wrapper.hpp"
#include "cosim/logic/pin_table.hpp"

namespace armature::cosim {
namespace {

struct BusPin {
  const char* name;
  std::uint32_t (*get)(const AxiSlavePins& pins);
  bool (*means)(const AxiSlavePins& pins);  // whether the level means something
};
constexpr auto kAlways = [](const AxiSlavePins&) { return true; };
constexpr auto kWithB = [](const AxiSlavePins& pins) { return pins.bvalid; };
constexpr auto kWithR = [](const AxiSlavePins& pins) { return pins.rvalid; };
constexpr BusPin kBusPins[]{
    {"s_axi_awready_o", [](const AxiSlavePins& p) { return std::uint32_t{p.awready}; }, kAlways},
    {"s_axi_wready_o", [](const AxiSlavePins& p) { return std::uint32_t{p.wready}; }, kAlways},
    {"s_axi_bvalid_o", [](const AxiSlavePins& p) { return std::uint32_t{p.bvalid}; }, kAlways},
    {"s_axi_bresp_o", [](const AxiSlavePins& p) { return std::uint32_t{p.bresp}; }, kWithB},
    {"s_axi_arready_o", [](const AxiSlavePins& p) { return std::uint32_t{p.arready}; }, kAlways},
    {"s_axi_rvalid_o", [](const AxiSlavePins& p) { return std::uint32_t{p.rvalid}; }, kAlways},
    {"s_axi_rresp_o", [](const AxiSlavePins& p) { return std::uint32_t{p.rresp}; }, kWithR},
    {"s_axi_rdata_o", [](const AxiSlavePins& p) { return p.rdata; }, kWithR},
};

class LockstepFabric final : public FabricWrapper {
 public:
  LockstepFabric(std::unique_ptr<Fabric> reference, std::unique_ptr<Fabric> model)
      : FabricWrapper{std::move(reference)}, model_{std::move(model)}, before_{outputs()} {
    compare_outputs(cycle(), outputs());
  }

  void set_inputs(const SocInputs& inputs) override {
    inner().set_inputs(inputs);
    model_->set_inputs(inputs);
  }
  void set_master(const AxiMasterPins& pins) override {
    inner().set_master(pins);
    model_->set_master(pins);
    request_ = pins.awvalid || pins.wvalid || pins.arvalid;
  }

  bool run(std::int64_t limit) override {
    const Cycles end = cycle() + Cycles{limit};
    bool changed = false;
    while (!changed && cycle() < end) {
      before_ = outputs();
      changed = inner().run(bus_is_busy() ? 1 : (end - cycle()).value());
      run_model();
    }
    return changed;
  }

  void stand_still(std::int64_t cycles) override {
    inner().stand_still(cycles);
    model_->stand_still(cycles);
  }
  void stop_clock_of(ClockGroup group) override {
    inner().stop_clock_of(group);
    model_->stop_clock_of(group);
  }

 private:
  // Whether a pin of the bus may change at the coming edge.
  [[nodiscard]] bool bus_is_busy() const {
    const AxiSlavePins slave = inner().slave();
    return request_ || !slave.awready || !slave.wready || !slave.arready;
  }

  // Runs the model to the cycle of the reference. The outputs of the reference change in that cycle only.
  void run_model() {
    while (model_->cycle() < cycle()) {
      model_->run((cycle() - model_->cycle()).value());
      compare_outputs(model_->cycle(), model_->cycle() < cycle() ? before_ : outputs());
    }
    compare_bus();
  }

  void compare_outputs(Cycles at, const SocOutputs& expected) const {
    if (model_->outputs() == expected) return;
    for (const Pin& pin : pins()) {
      if (!pin.is_input()) compare(at, pin.name, pin.get({}, expected), pin.get({}, model_->outputs()));
    }
  }

  void compare_bus() const {
    const AxiSlavePins expected = inner().slave();
    const AxiSlavePins found = model_->slave();
    for (const BusPin& pin : kBusPins) {
      if (pin.means(expected)) compare(cycle(), pin.name, pin.get(expected), pin.get(found));
    }
  }

  static void compare(Cycles at, std::string_view pin, std::uint32_t expected, std::uint32_t found) {
    if (expected == found) return;
    throw EnginesDiffer{at, fmt::format("{} is 0x{:X} with the RTL and 0x{:X} with the model", pin, expected, found)};
  }

  std::unique_ptr<Fabric> model_;
  SocOutputs before_;  // of the reference, before its latest run
  bool request_ = false;
};

}  // namespace

std::unique_ptr<Fabric> in_lockstep(std::unique_ptr<Fabric> reference, std::unique_ptr<Fabric> model) {
  return std::make_unique<LockstepFabric>(std::move(reference), std::move(model));
}

}  // namespace armature::cosim
