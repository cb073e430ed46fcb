// The logic for `armature serve`: register accesses, pins and the clock.
//
// Simulated time passes only in access(), run() and run_until_irq(), so that the same calls give the same cycles and
// values. There is no controller and no plant: inputs keep the levels of the last set_inputs().
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "controller/base/units.hpp"
#include "cosim/soc/soc.hpp"

namespace armature::cosim {

// Called every kStopCycles of a run; true ends it early.
using StopRequest = std::function<bool()>;

class ServedSoc {
 public:
  // About 0.5 ms of host time, about 10 ms while a waveform is written.
  static constexpr Cycles kStopCycles{1 << 12};

  // `soc` must be at cycle 0.
  explicit ServedSoc(std::unique_ptr<Soc> soc);

  // One register access, with the master's latency each way. Returns in the cycle in which a processor would receive
  // the response. access(), run() and run_until_irq() may throw LogicCheckFailed.
  BusResponse access(const BusRequest& request);

  // Runs `cycles` clock edges. Returns false when a stop request has ended it earlier.
  bool run(Cycles cycles, const StopRequest& stop);

  // Runs until a bit of irq_o is high, at most `limit` clock edges; zero edges when a bit is high already. Returns
  // whether a bit is high, or none after a stop request.
  std::optional<bool> run_until_irq(Cycles limit, const StopRequest& stop);

  // Clock edges since reset was released.
  [[nodiscard]] Cycles now() const { return soc_->now(); }

  [[nodiscard]] const SocInputs& inputs() const { return inputs_; }
  [[nodiscard]] const SocOutputs& outputs() const { return soc_->outputs(); }
  // Sets the levels from the next clock edge on.
  void set_inputs(const SocInputs& inputs);

  // An access that takes longer than this ends with BusError::kTimeout.
  [[nodiscard]] Cycles access_timeout() const { return soc_->access_timeout(); }

  // Both throw WaveError.
  void open_wave(const std::filesystem::path& file, WaveFormat format) { soc_->open_wave(file, format); }
  void close_wave() { soc_->close_wave(); }

 private:
  std::unique_ptr<Soc> soc_;
  SocInputs inputs_;
};

}  // namespace armature::cosim
