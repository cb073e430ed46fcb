#include "cosim/flips/flip_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <tuple>

#include "cosim/scenario/fault_text.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/shell_text.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

constexpr std::string_view kTableHead =
    "                                                                   ticks to the first response\n"
    "part                flips   masked  finished  stopped  silent   least  median    99 %    most\n";

std::string row_text(std::string_view name, const FlipRow& row) {
  const auto at = [&](Outcome outcome) { return row.outcomes[static_cast<std::size_t>(outcome)]; };
  std::string text = fmt::format("{:<16}{:>9}{:>9}{:>10}{:>9}{:>8}", name, sum_of(row.outcomes), at(Outcome::kMasked),
                                 at(Outcome::kFinished), at(Outcome::kStopped), silent_in(row.outcomes));
  if (const Latency latency = latency_of(row.latencies); latency.runs > 0) {
    text += fmt::format("{:>8}{:>8}{:>8}{:>8}", latency.least, latency.median, latency.most_of_all, latency.most);
  }
  return text + '\n';
}

FlipResult result_of(const Json& json) {
  FlipResult result{
      .flip = {.part = json.at("part").get<std::string>(),
               .name = json.at("name").get<std::string>(),
               .bit = json.at("bit").get<int>()},
      .at = to_cycles(json.at("at_s").get<double>()),
      .verdict = {.outcome = enumerator_of<Outcome>(json.at("outcome").get<std::string>()).value_or(Outcome::kFailed),
                  .reason = json.at("reason").get<std::string>()}};
  if (json.contains("offset")) result.flip.offset = json.at("offset").get<std::int64_t>();
  return result;
}

Json json_of(const FlipResult& result) {
  Json json{{"part", result.flip.part},
            {"name", result.flip.name},
            {"bit", result.flip.bit},
            {"at_s", to_seconds(result.at)},
            {"outcome", word_of(result.verdict.outcome)},
            {"reason", result.verdict.reason}};
  if (result.flip.offset) json["offset"] = *result.flip.offset;
  return json;
}

FlipTable flip_table_of(const Json& json) {
  FlipTable table;
  const Json& sweep = json.at("sweep");
  table.head = {.scenario = sweep.at("scenario").get<std::string>(),
                .seed = sweep.at("seed").get<std::uint64_t>(),
                .instants_s = sweep.at("instants_s").get<std::vector<double>>(),
                .run = sweep.at("run").get<std::string>(),
                .bits = sweep.at("bits").get<std::string>(),
                .flips = sweep.at("flips").get<std::int64_t>()};
  table.shards = json.at("shards").get<std::vector<std::string>>();
  for (const auto& [name, row] : json.at("parts").items()) {
    table.parts[name] = {counts_of(row.at("outcomes")), latencies_of(row.at("latency_ticks"))};
  }
  for (const Json& flip : json.at("silent")) table.silent.push_back(result_of(flip));
  return table;
}

std::string at_text(const FlipResult& result) {
  return fixed_text(to_seconds(result.at), 8);
}

}  // namespace

void FlipTable::add(const FlipResult& result) {
  FlipRow& row = parts[result.flip.part];
  ++row.outcomes[static_cast<std::size_t>(result.verdict.outcome)];
  if (result.verdict.latency_ticks) ++row.latencies[*result.verdict.latency_ticks];
  if (is_silent(result.verdict.outcome)) silent.push_back(result);
}

void FlipTable::merge(const FlipTable& other, const std::string& file) {
  if (head != other.head) throw InputError{file, "is of another sweep: scenario, seed, instants or bits differ"};
  add_shards(shards, other.shards, file);
  for (const auto& [name, from] : other.parts) {
    FlipRow& row = parts[name];
    add_counts(row.outcomes, from.outcomes);
    add_counts(row.latencies, from.latencies);
  }
  silent.insert(silent.end(), other.silent.begin(), other.silent.end());
  std::ranges::sort(silent, {}, [](const FlipResult& one) { return std::tie(one.at, one.flip); });
  if (missing() == 0) shards.clear();
}

FlipRow FlipTable::total() const {
  FlipRow total;
  for (const auto& [name, row] : parts) {
    add_counts(total.outcomes, row.outcomes);
    add_counts(total.latencies, row.latencies);
  }
  return total;
}

Json to_json(const FlipTable& table) {
  Json json;
  json["sweep"] = {{"scenario", table.head.scenario}, {"seed", table.head.seed}, {"instants_s", table.head.instants_s},
                   {"run", table.head.run},           {"bits", table.head.bits}, {"flips", table.head.flips}};
  json["shards"] = table.shards;
  json["parts"] = Json::object();
  for (const auto& [name, row] : table.parts) {
    json["parts"][name] = {{"outcomes", counts_json(row.outcomes)}, {"latency_ticks", latencies_json(row.latencies)}};
  }
  json["silent"] = Json::array();
  for (const FlipResult& result : table.silent) json["silent"].push_back(json_of(result));
  return json;
}

FlipTable flip_table(const std::string& text, const std::string& file) {
  try {
    return flip_table_of(Json::parse(text));
  } catch (const Json::exception& error) {
    throw InputError{file, std::string{"no table of 'armature flips': "} + error.what()};
  }
}

std::string flip_table_text(const FlipTable& table) {
  std::string text{kTableHead};
  for (const auto& [name, row] : table.parts) text += row_text(name, row);
  return text + row_text("all", table.total());
}

std::string silent_flip_text(const FlipResult& result, const FlipHead& head) {
  const std::string fault = fmt::format("fault=[{{at_s={},{}}}]", at_text(result), keys_of(result.flip));
  return fmt::format("SILENT  {} at {} s: {}: {}\n      to repeat it: {} {} --set {}\n",
                     fault_text({.kind = fault_of(result.flip)}), at_text(result), outcome_text(result.verdict.outcome),
                     result.verdict.reason, head.run, shell_word(head.scenario), shell_word(fault));
}

}  // namespace armature::cosim
