#include "cosim/campaign/campaign_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string_view>

#include "cosim/campaign/draw_fault.hpp"
#include "cosim/text/xml_text.hpp"

namespace armature::cosim {
namespace {

// The rows of the table: name, runs with this fault alone, runs with it and another one.
struct ReportRow {
  std::string name;
  OutcomeCounts alone{}, with_others{};
  Latency latency{};
};

std::vector<ReportRow> rows_of(const CampaignTable& table) {
  std::vector<ReportRow> rows{{.name = "no fault", .alone = table.without}};
  for (const std::string_view name : fault_kind_names()) {
    const auto found = table.kinds.find(std::string{name});
    if (found == table.kinds.end()) continue;
    const KindRow& kind = found->second;
    rows.push_back({std::string{name}, kind.alone, kind.with_others, latency_of(kind.latencies)});
  }
  return rows;
}

std::vector<std::string> cells_of(const ReportRow& row) {
  const auto at = [&](Outcome outcome) { return std::to_string(row.alone[static_cast<std::size_t>(outcome)]); };
  std::vector<std::string> cells{row.name,
                                 at(Outcome::kFinished),
                                 at(Outcome::kStopped),
                                 at(Outcome::kMasked),
                                 std::to_string(silent_in(row.alone)),
                                 std::to_string(sum_of(row.with_others)),
                                 std::to_string(silent_in(row.with_others))};
  const Latency& latency = row.latency;
  for (const std::int64_t ticks : {latency.least, latency.median, latency.most_of_all, latency.most}) {
    cells.push_back(latency.runs == 0 ? "" : std::to_string(ticks));
  }
  return cells;
}

const std::vector<std::string>& head_cells() {
  static const std::vector<std::string> kHead{"fault",  "finished", "stopped", "masked", "silent", "in pairs",
                                              "silent", "least",    "median",  "99 %",   "most"};
  return kHead;
}

std::string counts_text(const CampaignTable& table) {
  std::string text =
      fmt::format("{} of {} runs, seed {}, engine {}", table.done, table.head.runs, table.head.seed, table.head.engine);
  const char* mark = ": ";
  for (std::size_t i = 0; i < kOutcomeCount; ++i) {
    if (table.all[i] == 0) continue;
    text += fmt::format("{}{} {}", mark, table.all[i], outcome_text(static_cast<Outcome>(i)));
    mark = ", ";
  }
  return text;
}

constexpr std::string_view kPageHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'">
<title>armature campaign</title>
<style>
body { margin: 24px; font: 14px/1.5 system-ui, "DejaVu Sans", Verdana, sans-serif; color: #1f2328; }
table { border-collapse: collapse; }
td, th { padding: 4px 16px 4px 0; border-bottom: 1px solid #eaeef2; text-align: right; vertical-align: top; }
td:first-child, th:first-child, .text td { text-align: left; }
.passed { color: #1a7f37; }
.failed { color: #cf222e; font-weight: 600; }
</style>
</head>
<body>
)";

std::string html_row(const std::vector<std::string>& cells, std::string_view element, std::string_view style = {}) {
  std::string row = style.empty() ? "<tr>" : fmt::format("<tr class=\"{}\">", style);
  for (const std::string& cell : cells) row += fmt::format("<{0}>{1}</{0}>", element, xml_text(cell));
  return row + "</tr>\n";
}

}  // namespace

std::string campaign_text(const CampaignTable& table) {
  std::vector<std::vector<std::string>> lines{head_cells()};
  for (const ReportRow& row : rows_of(table)) lines.push_back(cells_of(row));
  constexpr std::size_t kNameWidth = 18, kWidth = 10;
  std::string text = fmt::format("{:>{}}\n", "ticks to the first response", kNameWidth + 10 * kWidth);
  for (const std::vector<std::string>& cells : lines) {
    std::string line = fmt::format("{:<{}}", cells.front(), kNameWidth);
    for (std::size_t i = 1; i < cells.size(); ++i) line += fmt::format("{:>{}}", cells[i], kWidth);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  return text + counts_text(table) + '\n';
}

std::string silent_run_text(const SilentRun& run, const std::string& replay) {
  std::string text = fmt::format("SILENT  run {}: {}: {}\n", run.run, outcome_text(run.outcome), run.reason);
  for (const std::string& fault : run.faults) text += fmt::format("      {}\n", fault);
  return text + fmt::format("      to repeat it: {} --only {}\n", replay, run.run);
}

std::string campaign_page(const CampaignTable& table, const std::string& replay) {
  std::string page{kPageHead};
  const std::int64_t silent = silent_in(table.all);
  fmt::format_to(std::back_inserter(page), "<h1 class=\"{}\">{} silent errors</h1>\n<p>{}</p>\n",
                 silent == 0 ? "passed" : "failed", silent, xml_text(counts_text(table)));
  page += "<p>The last four columns: ticks from the begin of the fault to the first response.</p>\n<table>\n";
  page += html_row(head_cells(), "th");
  for (const ReportRow& row : rows_of(table)) {
    page += html_row(cells_of(row), "td", silent_in(row.alone) + silent_in(row.with_others) == 0 ? "" : "failed");
  }
  page += "</table>\n";
  if (!table.silent.empty()) page += "<h2>Silent errors</h2>\n<table class=\"text\">\n";
  for (const SilentRun& run : table.silent) {
    page += html_row({outcome_text(run.outcome), run.reason, fmt::format("{}", fmt::join(run.faults, "; ")),
                      fmt::format("{} --only {}", replay, run.run)},
                     "td");
  }
  if (!table.silent.empty()) page += "</table>\n";
  return page + "</body>\n</html>\n";
}

std::vector<JunitCase> campaign_cases(const CampaignTable& table, const std::string& replay) {
  std::vector<JunitCase> cases;
  const std::vector<ReportRow> rows = rows_of(table);
  for (const ReportRow& row : rows) {
    JunitCase one{.name = row.name};
    for (std::size_t i = 0; i < kOutcomeCount; ++i) {
      const std::int64_t runs = row.alone[i] + row.with_others[i];
      if (runs > 0) one.properties.emplace_back(kWordsOf<Outcome>[i], std::to_string(runs));
    }
    for (const SilentRun& run : table.silent) {
      const bool here = run.kinds.empty() ? &row == &rows.front() : std::ranges::count(run.kinds, row.name) > 0;
      if (here) one.failure += silent_run_text(run, replay);
    }
    cases.push_back(std::move(one));
  }
  return cases;
}

}  // namespace armature::cosim
