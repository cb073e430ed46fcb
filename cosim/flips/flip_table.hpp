// The results of a sweep as counts, a row for each block of the logic, or part of the memory. Those of several shards
// give the table of the whole.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "cosim/campaign/judge/outcome_counts.hpp"
#include "cosim/flips/flip_sweep.hpp"
#include "cosim/text/json.hpp"

namespace armature::cosim {

struct FlipRow {
  OutcomeCounts outcomes{};
  LatencyCounts latencies{};
};

// What the results depend on.
struct FlipHead {
  std::string scenario{};  // as the user named it
  std::uint64_t seed = 1;
  std::vector<double> instants_s{};
  std::string run{};       // the command that runs the scenario, without its name: `armature run --engine rtl`
  std::string bits{};      // which of them, in the words of the command line
  std::int64_t flips = 0;  // of all shards
  friend bool operator==(const FlipHead&, const FlipHead&) = default;
};

struct FlipTable {
  FlipHead head{};
  std::vector<std::string> shards{};       // `0/4`, if there are several
  std::map<std::string, FlipRow> parts{};  // by name
  std::vector<FlipResult> silent{};        // in the order of instants and places

  void add(const FlipResult& result);
  // Throws InputError if the tables are not of one sweep, or have the same shard. `file` is for the message.
  void merge(const FlipTable& other, const std::string& file);
  [[nodiscard]] FlipRow total() const;
  [[nodiscard]] std::int64_t missing() const { return head.flips - sum_of(total().outcomes); }
};

[[nodiscard]] Json to_json(const FlipTable& table);
// Throws InputError.
[[nodiscard]] FlipTable flip_table(const std::string& text, const std::string& file);
// Lines with their ends, for a screen.
[[nodiscard]] std::string flip_table_text(const FlipTable& table);
// A silent error, and the command that repeats it.
[[nodiscard]] std::string silent_flip_text(const FlipResult& result, const FlipHead& head);

}  // namespace armature::cosim
