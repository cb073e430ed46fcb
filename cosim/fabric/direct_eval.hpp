// Evaluates a rising clock edge of a verilated model without the edge detection in eval().
//
// tools/direct_eval generates the specialisation of a model during the build, if it knows the form of the model.
#pragma once

#include "cosim/fabric/gated_clocks.hpp"

namespace armature::cosim {

template <class Model>
struct DirectEval {
  static constexpr bool kKnown = false;
  // Evaluates the rising edges of `clocks`. Falling edges need no call. The clock pins keep their levels, so eval() can
  // follow any number of calls. All clock pins must be 0.
  static void rise(Model& model, const Clocks& clocks) = delete;
};

}  // namespace armature::cosim
