// The flops of a verilated model, by the names that they have in the design and in waveforms.
//
// A flop is a bit that keeps its value when all wires are computed anew. Verilator also keeps some wires that only the
// next clock edge reads, and which it computes before. To invert them has no effect. Memories (arrays that are called
// `memory`) are not in the list.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "cosim/fabric/flops/flop.hpp"
#include "cosim/fabric/flops/flop_places.hpp"

namespace armature::cosim {

class Flops {
 public:
  // `settle` computes the wires of the model. Both must outlive this object, and the wires must be up to date.
  Flops(const std::vector<FlopPlace>& places, std::function<void()> settle);

  // In the order of their names.
  [[nodiscard]] const std::vector<Flop>& list() const { return list_; }

  // Inverts a bit, and computes the wires. Returns false, and does nothing, if there is no such flop or bit.
  bool flip(std::string_view name, int bit);

  // Of the values of all flops.
  [[nodiscard]] std::uint64_t digest() const;

 private:
  [[nodiscard]] bool keeps_its_value(unsigned char* byte, unsigned mask) const;

  std::function<void()> settle_;
  std::vector<Flop> list_;
  std::vector<unsigned char*> data_;  // of each
};

}  // namespace armature::cosim
