#include "cosim/campaign/campaign_table.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "cosim/text/input_error.hpp"

namespace armature::cosim {
namespace {

CampaignTable parsed(const Json& json) {
  CampaignTable table;
  const Json& head = json.at("campaign");
  table.head = {.seed = head.at("seed").get<std::uint64_t>(),
                .runs = head.at("runs").get<std::int64_t>(),
                .engine = head.at("engine").get<std::string>(),
                .robots = head.at("robots").get<std::vector<std::string>>(),
                .only_kinds = head.at("only_kinds").get<std::vector<std::string>>()};
  table.shards = json.at("shards").get<std::vector<std::string>>();
  table.done = json.at("done").get<std::int64_t>();
  table.all = counts_of(json.at("outcomes"));
  table.without = counts_of(json.at("without_fault"));
  for (const auto& [name, kind] : json.at("kinds").items()) {
    KindRow& row = table.kinds[name];
    row.alone = counts_of(kind.at("alone"));
    row.with_others = counts_of(kind.at("with_others"));
    row.latencies = latencies_of(kind.at("latency_ticks"));
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
  if (head != other.head)
    throw InputError{file, "is of another campaign: seed, runs, engine, robots or kinds of faults differ"};
  add_shards(shards, other.shards, file);
  done += other.done;
  add_counts(all, other.all);
  add_counts(without, other.without);
  for (const auto& [name, from] : other.kinds) {
    KindRow& row = kinds[name];
    add_counts(row.alone, from.alone);
    add_counts(row.with_others, from.with_others);
    add_counts(row.latencies, from.latencies);
  }
  silent.insert(silent.end(), other.silent.begin(), other.silent.end());
  std::ranges::sort(silent, {}, &SilentRun::run);
  if (is_complete()) shards.clear();
}

Json to_json(const CampaignTable& table) {
  Json json;
  json["campaign"] = {{"seed", table.head.seed},
                      {"runs", table.head.runs},
                      {"engine", table.head.engine},
                      {"robots", table.head.robots},
                      {"only_kinds", table.head.only_kinds}};
  json["shards"] = table.shards;
  json["done"] = table.done;
  json["outcomes"] = counts_json(table.all);
  json["without_fault"] = counts_json(table.without);
  json["kinds"] = Json::object();
  for (const auto& [name, row] : table.kinds) {
    json["kinds"][name] = {{"alone", counts_json(row.alone)},
                           {"with_others", counts_json(row.with_others)},
                           {"latency_ticks", latencies_json(row.latencies)}};
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
