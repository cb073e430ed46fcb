#include "cosim/campaign/judge/outcome_counts.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "cosim/text/input_error.hpp"

namespace armature::cosim {

std::int64_t sum_of(const OutcomeCounts& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
}

std::int64_t silent_in(const OutcomeCounts& counts) {
  std::int64_t silent = 0;
  for (std::size_t i = 0; i < kOutcomeCount; ++i) {
    if (is_silent(static_cast<Outcome>(i))) silent += counts[i];
  }
  return silent;
}

void add_counts(OutcomeCounts& to, const OutcomeCounts& from) {
  for (std::size_t i = 0; i < kOutcomeCount; ++i) to[i] += from[i];
}

Json counts_json(const OutcomeCounts& counts) {
  Json json = Json::object();
  for (std::size_t i = 0; i < kOutcomeCount; ++i) json[std::string{kWordsOf<Outcome>[i]}] = counts[i];
  return json;
}

OutcomeCounts counts_of(const Json& json) {
  OutcomeCounts counts{};
  for (std::size_t i = 0; i < kOutcomeCount; ++i) {
    counts[i] = json.at(std::string{kWordsOf<Outcome>[i]}).get<std::int64_t>();
  }
  return counts;
}

void add_counts(LatencyCounts& to, const LatencyCounts& from) {
  for (const auto& [ticks, runs] : from) to[ticks] += runs;
}

Json latencies_json(const LatencyCounts& counts) {
  Json json = Json::array();
  for (const auto& [ticks, runs] : counts) json.push_back({ticks, runs});
  return json;
}

LatencyCounts latencies_of(const Json& json) {
  LatencyCounts counts;
  for (const Json& pair : json) counts[pair.at(0).get<std::int64_t>()] = pair.at(1).get<std::int64_t>();
  return counts;
}

Latency latency_of(const LatencyCounts& counts) {
  Latency latency;
  for (const auto& [ticks, runs] : counts) latency.runs += runs;
  if (latency.runs == 0) return latency;
  // The smallest value that is not exceeded by so many of a hundred.
  const auto quantile = [&](std::int64_t percent) {
    const std::int64_t wanted = (latency.runs * percent + 99) / 100;
    std::int64_t seen = 0;
    for (const auto& [ticks, runs] : counts) {
      seen += runs;
      if (seen >= wanted) return ticks;
    }
    return counts.rbegin()->first;
  };
  latency.least = counts.begin()->first;
  latency.median = quantile(50);
  latency.most_of_all = quantile(99);
  latency.most = counts.rbegin()->first;
  return latency;
}

void add_shards(std::vector<std::string>& to, const std::vector<std::string>& from, const std::string& file) {
  for (const std::string& shard : from) {
    if (std::ranges::find(to, shard) != to.end()) throw InputError{file, "has the shard " + shard + " again"};
  }
  if (to.empty() || from.empty()) throw InputError{file, "both tables must be those of a shard"};
  to.insert(to.end(), from.begin(), from.end());
  std::ranges::sort(to);
}

}  // namespace armature::cosim
