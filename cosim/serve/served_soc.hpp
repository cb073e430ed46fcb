// The logic on a test stand: its bus, its pins and its clock, each moved only by a call from here.
//
// Simulated time passes in access(), run() and run_until_irq() alone, so that the same calls give the same cycles and
// values. There is no controller and no plant: inputs keep the level that set_inputs() gave them.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "controller/core/units.hpp"
#include "cosim/soc/soc.hpp"

namespace armature::cosim {

// Asked every kStopCycles of a run; true ends it early.
using StopRequest = std::function<bool()>;

class ServedSoc {
 public:
  // Half a millisecond of host time, some ten while a waveform is written.
  static constexpr Cycles kStopCycles{1 << 12};

  // `soc` stands at cycle 0.
  explicit ServedSoc(std::unique_ptr<Soc> soc);

  // One register access, with the master's latency each way. Returns in the cycle in which a processor would see the
  // response. All clocking functions may throw FabricCheckFailed.
  BusResponse access(const BusRequest& request);

  // `cycles` clock edges. Less than that only after a stop request: false.
  bool run(Cycles cycles, const StopRequest& stop);

  // At most `limit` clock edges, until a bit of irq_o is high; none when one is high already. Returns whether one is,
  // or nothing after a stop request.
  std::optional<bool> run_until_irq(Cycles limit, const StopRequest& stop);

  // Clock edges since reset was released.
  [[nodiscard]] Cycles now() const { return soc_->now(); }

  [[nodiscard]] const FabricInputs& inputs() const { return inputs_; }
  [[nodiscard]] const FabricOutputs& outputs() const { return soc_->outputs(); }
  // Levels from the next clock edge on.
  void set_inputs(const FabricInputs& inputs);

  // An access that takes longer than this ends with BusError::kTimeout.
  [[nodiscard]] Cycles longest_access() const { return soc_->longest_access(); }

  // Both throw WaveError.
  void open_wave(const std::filesystem::path& file, WaveFormat format) { soc_->open_wave(file, format); }
  void close_wave() { soc_->close_wave(); }

 private:
  std::unique_ptr<Soc> soc_;
  FabricInputs inputs_;
};

}  // namespace armature::cosim
