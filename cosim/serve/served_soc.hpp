// The logic on a test stand: its bus, its pins and its clock, each moved only by a call from here.
//
// Simulated time passes in access(), run() and run_until_irq() alone, so that the same calls give the same cycles and
// values. There is no controller and no plant: inputs keep the level that set_inputs() gave them.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "controller/core/units.hpp"
#include "cosim/bus/axi_lite_master.hpp"
#include "cosim/fabric/fabric.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

// Asked every kStopCycles of a run; true ends it early.
using StopRequest = std::function<bool()>;

class ServedSoc {
 public:
  // Half a millisecond of host time, some ten while a waveform is written.
  static constexpr Cycles kStopCycles{1 << 12};

  explicit ServedSoc(std::unique_ptr<Fabric> fabric, const BusSpec& bus = {});

  // One register access, with the master's latency each way. Returns in the cycle in which a processor would see the
  // response. All clocking functions may throw FabricCheckFailed.
  BusResponse access(const BusRequest& request);

  // `cycles` clock edges. Less than that only after a stop request: false.
  bool run(Cycles cycles, const StopRequest& stop);

  // At most `limit` clock edges, until a bit of irq_o is high; none when one is high already. Returns whether one is,
  // or nothing after a stop request.
  std::optional<bool> run_until_irq(Cycles limit, const StopRequest& stop);

  // Clock edges since reset was released.
  [[nodiscard]] Cycles now() const { return fabric_->cycle(); }

  [[nodiscard]] const FabricInputs& inputs() const { return inputs_; }
  [[nodiscard]] const FabricOutputs& outputs() const { return fabric_->outputs(); }
  // Levels from the next clock edge on.
  void set_inputs(const FabricInputs& inputs);

  [[nodiscard]] Fabric& fabric() { return *fabric_; }
  [[nodiscard]] const BusSpec& bus() const { return bus_spec_; }

 private:
  std::unique_ptr<Fabric> fabric_;
  BusSpec bus_spec_;
  AxiLiteMaster bus_;
  FabricInputs inputs_;
};

}  // namespace armature::cosim
