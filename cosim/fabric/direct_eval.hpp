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
  static void rise(Model& model, Clocks clocks) = delete;
};

// A clock edge in the faster way that the model has.
template <class Model>
[[gnu::always_inline]] inline void evaluate_edge(Model& model, Clocks clocks) {
  if constexpr (DirectEval<Model>::kKnown) {
    DirectEval<Model>::rise(model, clocks);
  } else {
    eval_edge(model, clocks);
  }
}

inline constexpr int kResetCycles = 16;  // longer than any synchroniser or reset pipeline

// Resets a new model. Its other inputs must have been driven.
template <class Model>
void reset(Model& model) {
  set_clocks(model, {});
  model.rst_ni = 0;
  model.eval();
  for (int i = 0; i < kResetCycles; ++i) evaluate_edge(model, needed_clocks(model));
  model.rst_ni = 1;
}

}  // namespace armature::cosim
