#include "cosim/campaign/campaign_table.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>
#include <utility>

#include "cosim/text/input_error.hpp"

namespace armature::cosim {
namespace {

OutcomeCounts counts_of(const Json& json) {
  OutcomeCounts counts{};
  for (std::size_t i = 0; i < kOutcomeCount; ++i) {
    counts[i] = json.at(std::string{kWordsOf<Outcome>[i]}).get<std::int64_t>();
  }
  return counts;
}

CampaignTable parsed(const Json& json) {
  CampaignTable table;
  const Json& head = json.at("campaign");
  table.head = {.seed = head.at("seed").get<std::uint64_t>(),
                .runs = head.at("runs").get<std::int64_t>(),
                .engine = head.at("engine").get<std::string>(),
                .robots = head.at("robots").get<std::vector<std::string>>()};
  table.shards = json.at("shards").get<std::vector<std::string>>();
  table.done = json.at("done").get<std::int64_t>();
  table.all = counts_of(json.at("outcomes"));
  table.without = counts_of(json.at("without_fault"));
  for (const auto& [name, kind] : json.at("kinds").items()) {
    KindRow& row = table.kinds[name];
    row.alone = counts_of(kind.at("alone"));
    row.with_others = counts_of(kind.at("with_others"));
    for (const Json& pair : kind.at("latency_ticks")) {
      row.latencies[pair.at(0).get<std::int64_t>()] = pair.at(1).get<std::int64_t>();
    }
  }
  for (const Json& run : json.at("silent")) {
    const auto outcome = enumerator_of<Outcome>(run.at("outcome").get<std::string>());
    table.silent.push_back({.run = run.at("run").get<std::int64_t>(),
                            .outcome = outcome.value_or(Outcome::kFailed),
                            .kinds = run.at("kinds").get<std::vector<std::string>>(),
                            .faults = run.at("faults").get<std::vector<std::string>>(),
                            .reason = run.at("reason").get<std::string>()});
  }
  return table;
}

}  // namespace

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

Latency latency_of(const KindRow& row) {
  Latency latency;
  for (const auto& [ticks, runs] : row.latencies) latency.runs += runs;
  if (latency.runs == 0) return latency;
  // The smallest value that is not exceeded by so many of a hundred.
  const auto quantile = [&](std::int64_t percent) {
    const std::int64_t wanted = (latency.runs * percent + 99) / 100;
    std::int64_t seen = 0;
    for (const auto& [ticks, runs] : row.latencies) {
      seen += runs;
      if (seen >= wanted) return ticks;
    }
    return row.latencies.rbegin()->first;
  };
  latency.least = row.latencies.begin()->first;
  latency.median = quantile(50);
  latency.most_of_all = quantile(99);
  latency.most = row.latencies.rbegin()->first;
  return latency;
}

Json latencies_json(const KindRow& row) {
  Json latencies = Json::array();
  for (const auto& [ticks, runs] : row.latencies) latencies.push_back({ticks, runs});
  return latencies;
}

void CampaignTable::add(const CampaignResult& result) {
  const auto outcome = static_cast<std::size_t>(result.verdict.outcome);
  ++done;
  ++all[outcome];
  if (result.kinds.empty()) ++without[outcome];
  const std::set<std::string> distinct(result.kinds.begin(), result.kinds.end());
  for (const std::string& kind : distinct) {
    KindRow& row = kinds[kind];
    ++(result.kinds.size() == 1 ? row.alone : row.with_others)[outcome];
    if (result.kinds.size() == 1 && result.verdict.latency_ticks) ++row.latencies[*result.verdict.latency_ticks];
  }
  if (is_silent(result.verdict.outcome)) {
    silent.push_back({result.run, result.verdict.outcome, result.kinds, result.faults, result.verdict.reason});
  }
}

void CampaignTable::merge(const CampaignTable& other, const std::string& file) {
  if (head != other.head) throw InputError{file, "is of another campaign: seed, runs, engine or robots differ"};
  for (const std::string& shard : other.shards) {
    if (std::ranges::find(shards, shard) != shards.end()) throw InputError{file, "has the shard " + shard + " again"};
  }
  if (shards.empty() || other.shards.empty()) throw InputError{file, "both tables must be those of a shard"};
  shards.insert(shards.end(), other.shards.begin(), other.shards.end());
  done += other.done;
  add_counts(all, other.all);
  add_counts(without, other.without);
  for (const auto& [name, from] : other.kinds) {
    KindRow& row = kinds[name];
    add_counts(row.alone, from.alone);
    add_counts(row.with_others, from.with_others);
    for (const auto& [ticks, runs] : from.latencies) row.latencies[ticks] += runs;
  }
  silent.insert(silent.end(), other.silent.begin(), other.silent.end());
  std::ranges::sort(silent, {}, &SilentRun::run);
  std::ranges::sort(shards);
  if (is_complete()) shards.clear();
}

Json to_json(const CampaignTable& table) {
  Json json;
  json["campaign"] = {{"seed", table.head.seed},
                      {"runs", table.head.runs},
                      {"engine", table.head.engine},
                      {"robots", table.head.robots}};
  json["shards"] = table.shards;
  json["done"] = table.done;
  json["outcomes"] = counts_json(table.all);
  json["without_fault"] = counts_json(table.without);
  json["kinds"] = Json::object();
  for (const auto& [name, row] : table.kinds) {
    json["kinds"][name] = {{"alone", counts_json(row.alone)},
                           {"with_others", counts_json(row.with_others)},
                           {"latency_ticks", latencies_json(row)}};
  }
  json["silent"] = Json::array();
  for (const SilentRun& run : table.silent) {
    json["silent"].push_back({{"run", run.run},
                              {"outcome", word_of(run.outcome)},
                              {"kinds", run.kinds},
                              {"faults", run.faults},
                              {"reason", run.reason}});
  }
  return json;
}

CampaignTable campaign_table(const std::string& text, const std::string& file) {
  try {
    return parsed(Json::parse(text));
  } catch (const Json::exception& error) {
    throw InputError{file, std::string{"no table of a campaign: "} + error.what()};
  }
}

}  // namespace armature::cosim
