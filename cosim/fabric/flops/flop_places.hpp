// Where a verilated model keeps the values of the design.
//
// tools/flops generates the specialisation of a model during the build, if it knows the form of the model.
#pragma once

#include <cstddef>

namespace armature::cosim {

// A signal of the design, or an array of such signals. An element begins at a byte, and its bits follow each other.
struct FlopPlace {
  const char* name;  // `u_axi_timer.u_core.enall_q`, below the top module
  void* data;
  std::size_t size;      // of all elements [bytes]
  std::size_t bits;      // of an element
  std::size_t elements;  // 1: no array
};

template <class Model>
struct FlopPlaces {
  static constexpr bool kKnown = false;
  // The places in this model, in any order. Some of them are wires.
  static void of(Model& model) = delete;
  // Computes all wires from the flops and the input pins.
  static void settle(Model& model) = delete;
};

}  // namespace armature::cosim
