// The results of a sweep as counts, a row for each block of the logic. Those of several shards give the table of the
// whole.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "cosim/campaign/judge/outcome_counts.hpp"
#include "cosim/flops/flop_sweep.hpp"
#include "cosim/text/json.hpp"

namespace armature::cosim {

// The block of a flop: `u_encoder` of `g_rtl.u_encoder.u_core.u_position.position_q`, `pins` of an output of the chip.
[[nodiscard]] std::string block_of(const std::string& flop);

struct FlopRow {
  OutcomeCounts outcomes{};
  LatencyCounts latencies{};
};

// What the results depend on.
struct FlopHead {
  std::string scenario{};  // as the user named it
  std::uint64_t seed = 1;
  std::vector<double> instants_s{};
  std::string flops{};     // which of them, in the words of the command line
  std::int64_t flips = 0;  // of all shards
  friend bool operator==(const FlopHead&, const FlopHead&) = default;
};

struct FlopTable {
  FlopHead head{};
  std::vector<std::string> shards{};        // `0/4`, if there are several
  std::map<std::string, FlopRow> blocks{};  // by the name of the block
  std::vector<FlopResult> silent{};         // in the order of instants and flops

  void add(const FlopResult& result);
  // Throws InputError if the tables are not of one sweep, or have the same shard. `file` is for the message.
  void merge(const FlopTable& other, const std::string& file);
  [[nodiscard]] FlopRow total() const;
  [[nodiscard]] std::int64_t missing() const { return head.flips - sum_of(total().outcomes); }
};

[[nodiscard]] Json to_json(const FlopTable& table);
// Throws InputError.
[[nodiscard]] FlopTable flop_table(const std::string& text, const std::string& file);
// Lines with their ends, for a screen.
[[nodiscard]] std::string flop_table_text(const FlopTable& table);
// A silent error, and the command that repeats it.
[[nodiscard]] std::string silent_flip_text(const FlopResult& result, const std::string& scenario);

}  // namespace armature::cosim
