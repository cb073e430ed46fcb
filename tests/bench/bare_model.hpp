// A scenario without the simulation around the logic: the levels of all input pins and of the bus, recorded once.
//
// The replay drives the recorded levels into the verilated model and evaluates the same edges of the same gated clocks.
// It has no bus master, plant or controller, and it reads no output. Its time is the limit of any simulation with
// this model.
#pragma once

#include <cstdint>
#include <vector>

#include "cosim/fabric/fabric.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::bench {

class BareModel final {
 public:
  // Runs `scenario` with the verilated logic of the variant `counts`, and records it. Throws std::runtime_error if the
  // run fails, or if the outputs of a replay differ from those of the run.
  explicit BareModel(const cosim::Scenario& scenario);

  // Clock edges since reset.
  [[nodiscard]] std::int64_t clocks() const { return clocks_; }

  void replay() const;

 private:
  class Recorder;
  // Clock edges with constant levels of all inputs.
  struct Stretch {
    std::int32_t clocks = 0;
    bool new_inputs = false, new_master = false;  // the next element of inputs_ or master_ applies from here on
    cosim::SocOutputs outputs;                    // after the last edge
  };

  // Calls after(model, stretch) at the end of each stretch.
  template <class After>
  void replay(After after) const;

  std::vector<Stretch> stretches_;
  std::vector<cosim::SocInputs> inputs_;
  std::vector<cosim::AxiMasterPins> master_;
  std::int64_t clocks_ = 0;
};

}  // namespace armature::bench
