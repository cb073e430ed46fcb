// The results of a sweep as counts, a row for each block of the logic.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "cosim/campaign/campaign_table.hpp"
#include "cosim/flops/flop_sweep.hpp"
#include "cosim/text/json.hpp"

namespace armature::cosim {

// The block of a flop: `u_encoder` of `g_rtl.u_encoder.u_core.u_position.position_q`, `pins` of an output of the chip.
[[nodiscard]] std::string block_of(const std::string& flop);

struct FlopTable {
  std::map<std::string, KindRow> blocks{};  // `alone`; by the name of the block
  std::vector<FlopResult> silent{};         // in the order of the flips

  void add(const FlopResult& result);
  [[nodiscard]] OutcomeCounts total() const;
};

[[nodiscard]] Json to_json(const FlopTable& table);
// Lines with their ends, for a screen.
[[nodiscard]] std::string flop_table_text(const FlopTable& table);
// A silent error, and the command that repeats it. `scenario`: as the user named it.
[[nodiscard]] std::string silent_flip_text(const FlopResult& result, const std::string& scenario);

}  // namespace armature::cosim
