// The state of a run at a cycle, as a ReversibleRun shows it.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "cosim/kernel/simulation_state.hpp"

namespace armature::cosim {

struct RunState {
  SimulationState seen;
  std::int64_t heard = 0;  // rows, events, actions and signals so far (RunListener)
  // SHA-256 of all that was heard so far and of `seen`: two states of a scenario with the same digest are the same.
  std::array<char, 64> digest{};

  [[nodiscard]] Cycles now() const { return seen.now; }
  [[nodiscard]] std::string_view digest_text() const { return {digest.data(), digest.size()}; }
};

}  // namespace armature::cosim
