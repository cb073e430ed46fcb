// Outcomes of runs as counts, which add up: those of several shards give the table of the whole.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "controller/base/words.hpp"
#include "cosim/campaign/judge/outcome.hpp"
#include "cosim/text/json.hpp"

namespace armature::cosim {

inline constexpr std::size_t kOutcomeCount = kWordsOf<Outcome>.size();
using OutcomeCounts = std::array<std::int64_t, kOutcomeCount>;

[[nodiscard]] std::int64_t sum_of(const OutcomeCounts& counts);
[[nodiscard]] std::int64_t silent_in(const OutcomeCounts& counts);
void add_counts(OutcomeCounts& to, const OutcomeCounts& from);
// By the words of the outcomes. counts_of() throws Json::exception.
[[nodiscard]] Json counts_json(const OutcomeCounts& counts);
[[nodiscard]] OutcomeCounts counts_of(const Json& json);

// How many runs have each latency [ticks].
using LatencyCounts = std::map<std::int64_t, std::int64_t>;

void add_counts(LatencyCounts& to, const LatencyCounts& from);
// Pairs of ticks and runs. latencies_of() throws Json::exception.
[[nodiscard]] Json latencies_json(const LatencyCounts& counts);
[[nodiscard]] LatencyCounts latencies_of(const Json& json);

struct Latency {
  std::int64_t runs = 0, least = 0, median = 0, most_of_all = 0 /* 99 % */, most = 0;
};
[[nodiscard]] Latency latency_of(const LatencyCounts& counts);

// Adds the names of the shards of another table of the same runs, and sorts them. Throws InputError if the table has
// one of them already, or if one of the tables is whole. `file`, of the other table, is for the message.
void add_shards(std::vector<std::string>& to, const std::vector<std::string>& from, const std::string& file);

}  // namespace armature::cosim
