#include "cosim/flops/flop_table.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string_view>

#include "cosim/text/number_text.hpp"
#include "cosim/text/shell_text.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

constexpr std::string_view kTableHead =
    "                                                                   ticks to the first response\n"
    "block               flips   masked  finished  stopped  silent   least  median    99 %    most\n";

std::string row_text(std::string_view name, const KindRow& row) {
  const auto at = [&](Outcome outcome) { return row.alone[static_cast<std::size_t>(outcome)]; };
  std::string text = fmt::format("{:<16}{:>9}{:>9}{:>10}{:>9}{:>8}", name, sum_of(row.alone), at(Outcome::kMasked),
                                 at(Outcome::kFinished), at(Outcome::kStopped), silent_in(row.alone));
  if (const Latency latency = latency_of(row); latency.runs > 0) {
    text += fmt::format("{:>8}{:>8}{:>8}{:>8}", latency.least, latency.median, latency.most_of_all, latency.most);
  }
  return text + '\n';
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
  KindRow& row = blocks[block_of(result.flip.flop)];
  ++row.alone[static_cast<std::size_t>(result.verdict.outcome)];
  if (result.verdict.latency_ticks) ++row.latencies[*result.verdict.latency_ticks];
  if (is_silent(result.verdict.outcome)) silent.push_back(result);
}

OutcomeCounts FlopTable::total() const {
  OutcomeCounts total{};
  for (const auto& [name, row] : blocks) add_counts(total, row.alone);
  return total;
}

Json to_json(const FlopTable& table) {
  Json json;
  json["blocks"] = Json::object();
  for (const auto& [name, row] : table.blocks) {
    json["blocks"][name] = {{"outcomes", counts_json(row.alone)}, {"latency_ticks", latencies_json(row)}};
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

std::string flop_table_text(const FlopTable& table) {
  std::string text{kTableHead};
  KindRow all;
  for (const auto& [name, row] : table.blocks) {
    text += row_text(name, row);
    for (const auto& [ticks, runs] : row.latencies) all.latencies[ticks] += runs;
  }
  all.alone = table.total();
  return text + row_text("all", all);
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
