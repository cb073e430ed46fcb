#include "cosim/flops/flop_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <tuple>

#include "cosim/text/input_error.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/shell_text.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

constexpr std::string_view kTableHead =
    "                                                                   ticks to the first response\n"
    "block               flips   masked  finished  stopped  silent   least  median    99 %    most\n";

std::string row_text(std::string_view name, const FlopRow& row) {
  const auto at = [&](Outcome outcome) { return row.outcomes[static_cast<std::size_t>(outcome)]; };
  std::string text = fmt::format("{:<16}{:>9}{:>9}{:>10}{:>9}{:>8}", name, sum_of(row.outcomes), at(Outcome::kMasked),
                                 at(Outcome::kFinished), at(Outcome::kStopped), silent_in(row.outcomes));
  if (const Latency latency = latency_of(row.latencies); latency.runs > 0) {
    text += fmt::format("{:>8}{:>8}{:>8}{:>8}", latency.least, latency.median, latency.most_of_all, latency.most);
  }
  return text + '\n';
}

FlopTable flop_table_of(const Json& json) {
  FlopTable table;
  const Json& sweep = json.at("sweep");
  table.head = {.scenario = sweep.at("scenario").get<std::string>(),
                .seed = sweep.at("seed").get<std::uint64_t>(),
                .instants_s = sweep.at("instants_s").get<std::vector<double>>(),
                .flops = sweep.at("flops").get<std::string>(),
                .flips = sweep.at("flips").get<std::int64_t>()};
  table.shards = json.at("shards").get<std::vector<std::string>>();
  for (const auto& [name, row] : json.at("blocks").items()) {
    table.blocks[name] = {counts_of(row.at("outcomes")), latencies_of(row.at("latency_ticks"))};
  }
  for (const Json& flip : json.at("silent")) {
    const auto outcome = enumerator_of<Outcome>(flip.at("outcome").get<std::string>());
    table.silent.push_back(
        {.flip = {.flop = flip.at("flop").get<std::string>(), .bit = flip.at("bit").get<int>()},
         .at = to_cycles(flip.at("at_s").get<double>()),
         .verdict = {.outcome = outcome.value_or(Outcome::kFailed), .reason = flip.at("reason").get<std::string>()}});
  }
  return table;
}

std::string at_text(const FlopResult& result) {
  return fixed_text(to_seconds(result.at), 8);
}

}  // namespace

std::string block_of(const std::string& flop) {
  const std::size_t begin = flop.find("u_"), end = flop.find('.', begin);
  return begin == std::string::npos || end == std::string::npos ? "pins" : flop.substr(begin, end - begin);
}

void FlopTable::add(const FlopResult& result) {
  FlopRow& row = blocks[block_of(result.flip.flop)];
  ++row.outcomes[static_cast<std::size_t>(result.verdict.outcome)];
  if (result.verdict.latency_ticks) ++row.latencies[*result.verdict.latency_ticks];
  if (is_silent(result.verdict.outcome)) silent.push_back(result);
}

void FlopTable::merge(const FlopTable& other, const std::string& file) {
  if (head != other.head) throw InputError{file, "is of another sweep: scenario, seed, instants or flops differ"};
  add_shards(shards, other.shards, file);
  for (const auto& [name, from] : other.blocks) {
    FlopRow& row = blocks[name];
    add_counts(row.outcomes, from.outcomes);
    add_counts(row.latencies, from.latencies);
  }
  silent.insert(silent.end(), other.silent.begin(), other.silent.end());
  std::ranges::sort(silent, {}, [](const FlopResult& one) { return std::tuple{one.at, one.flip.flop, one.flip.bit}; });
  if (missing() == 0) shards.clear();
}

FlopRow FlopTable::total() const {
  FlopRow total;
  for (const auto& [name, row] : blocks) {
    add_counts(total.outcomes, row.outcomes);
    add_counts(total.latencies, row.latencies);
  }
  return total;
}

Json to_json(const FlopTable& table) {
  Json json;
  json["sweep"] = {{"scenario", table.head.scenario},
                   {"seed", table.head.seed},
                   {"instants_s", table.head.instants_s},
                   {"flops", table.head.flops},
                   {"flips", table.head.flips}};
  json["shards"] = table.shards;
  json["blocks"] = Json::object();
  for (const auto& [name, row] : table.blocks) {
    json["blocks"][name] = {{"outcomes", counts_json(row.outcomes)}, {"latency_ticks", latencies_json(row.latencies)}};
  }
  json["silent"] = Json::array();
  for (const FlopResult& result : table.silent) {
    json["silent"].push_back({{"flop", result.flip.flop},
                              {"bit", result.flip.bit},
                              {"at_s", to_seconds(result.at)},
                              {"outcome", word_of(result.verdict.outcome)},
                              {"reason", result.verdict.reason}});
  }
  return json;
}

FlopTable flop_table(const std::string& text, const std::string& file) {
  try {
    return flop_table_of(Json::parse(text));
  } catch (const Json::exception& error) {
    throw InputError{file, std::string{"no table of 'armature flops': "} + error.what()};
  }
}

std::string flop_table_text(const FlopTable& table) {
  std::string text{kTableHead};
  for (const auto& [name, row] : table.blocks) text += row_text(name, row);
  return text + row_text("all", table.total());
}

std::string silent_flip_text(const FlopResult& result, const std::string& scenario) {
  const std::string fault = fmt::format("fault=[{{at_s={},kind=\"flop_flip\",flop=\"{}\",bit={}}}]", at_text(result),
                                        result.flip.flop, result.flip.bit);
  return fmt::format(
      "SILENT  bit {} of {} at {} s: {}: {}\n      to repeat it: armature run {} --engine rtl --set {}\n",
      result.flip.bit, result.flip.flop, at_text(result), outcome_text(result.verdict.outcome), result.verdict.reason,
      shell_word(scenario), shell_word(fault));
}

}  // namespace armature::cosim
