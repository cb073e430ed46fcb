// The texts of a comparison.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "cosim/text/number_text.hpp"
#include "cosim/text/shell_text.hpp"
#include "cosim/trace/columns.hpp"
#include "cosim/trace/compare.hpp"

namespace armature::cosim {
namespace {

std::string list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

// Name of the trace as a whole.
const std::string& whole(const TraceName& name) {
  return name.file.empty() ? name.value : name.file;
}

// The line with its file; empty when there is none.
std::string line_text(const TraceName& name, int line) {
  if (line == 0 || name.file.empty()) return {};
  const std::string file = name.value.empty() ? name.file : std::filesystem::path{name.file}.filename().string();
  return file + " line " + std::to_string(line);
}

// `golden 90 (golden.csv line 11)`, or `a.csv: 90 (line 11)`.
std::string value_text(const TraceName& name, const std::string& value, int line) {
  if (name.value.empty()) return name.file + ": " + value + " (line " + std::to_string(line) + ")";
  const std::string position = line_text(name, line);
  return name.value + " " + value + (position.empty() ? "" : " (" + position + ")");
}

std::string tick_text(const RowPosition& position) {
  return "tick " + std::to_string(position.tick);
}

std::string time_text(const RowPosition& position) {
  constexpr int kDigits = 6;
  return position.time_s ? fixed_text(*position.time_s, kDigits) + " s" : std::string{};
}

std::string with_time(const RowPosition& position) {
  const std::string time = time_text(position);
  return tick_text(position) + (time.empty() ? "" : " (" + time + ")");
}

// `tick 180 (0.009 s; golden.csv line 11, trace.csv line 11)`
std::string with_lines(const Comparison& comparison, const RowPosition& position) {
  std::string text = time_text(position);
  std::string separator = "; ";
  for (const std::string& line : {line_text(comparison.a, position.line_a), line_text(comparison.b, position.line_b)}) {
    if (line.empty()) continue;
    text += (text.empty() ? "" : separator) + line;
    separator = ", ";
  }
  return tick_text(position) + (text.empty() ? "" : " (" + text + ")");
}

std::string digest_text(const Comparison& comparison) {
  const DigestMismatch& digest = *comparison.digest;
  if (!digest.after) {
    return "  the runs differ already in the first common row, " + with_lines(comparison, digest.until) +
           ", or in a tick before it\n";
  }
  return "  the runs first differ between " + with_lines(comparison, *digest.after) + " and " +
         with_lines(comparison, digest.until) +
         "\n  these ticks: " + show_ticks_command(comparison.scenario, digest.after->tick, digest.until.tick) + "\n";
}

bool same_rows(const Comparison& comparison) {
  return comparison.rows_differ == 0 && !comparison.digest && comparison.rows_only_a == 0 &&
         comparison.rows_only_b == 0;
}

bool is_one_digest(const std::vector<std::string>& columns) {
  return columns.size() == 1 && is_digest(columns.front());
}

void append_only_in(std::string& text, std::int64_t rows, std::optional<std::int64_t> first, const std::string& file) {
  if (rows == 0) return;
  text +=
      "  " + std::to_string(rows) + " rows only in " + file + ", the first at tick " + std::to_string(*first) + "\n";
}

bool deviates(const ColumnDeviation& column) {
  return column.largest != 0 || column.rows != 0;
}

std::string column_text(const ColumnDeviation& column) {
  const ColumnRule& rule = column.rule;
  const std::string rows = std::to_string(column.rows) + " rows ";
  const std::string at = " at tick " + std::to_string(column.tick) + ", ";
  if (rule.kind == ColumnRule::Kind::kText) return "differs first" + at + rows + "differ";
  if (rule.kind == ColumnRule::Kind::kInteger) return number_text(column.largest) + at + rows + "differ";
  const std::string largest =
      std::isfinite(column.largest) ? fixed_text(column.largest, rule.digits) : std::string{"no number (nan)"};
  return largest + at + rows + "beyond " + number_text(rule.tolerance);
}

}  // namespace

// At full rate line 2 is tick 0.
std::string show_ticks_command(const std::string& scenario, std::int64_t first, std::int64_t last) {
  constexpr const char* kFullRateFolder = "out/full_rate";
  return "armature run " + (scenario.empty() ? std::string{"SCENARIO"} : shell_word(scenario)) +
         " --set trace.every_ticks=1 --out " + kFullRateFolder + "; sed -n '1p;" + std::to_string(first + 2) + "," +
         std::to_string(last + 2) + "p' " + kFullRateFolder + "/trace.csv";
}

bool Comparison::equal() const {
  return same_rows(*this) && columns_only_a.empty() && columns_only_b.empty();
}

bool Comparison::equal_but_for_version() const {
  return same_rows(*this) && is_one_digest(columns_only_a) && is_one_digest(columns_only_b);
}

std::string Comparison::counts() const {
  if (equal()) {
    const std::string between =
        rows_between == 0 ? "" : "; " + std::to_string(rows_between) + " rows between them are in one trace only";
    const std::string cycles =
        other_cycles ? "; ticks between them are not compared, because triggers come at other clock cycles" : "";
    return std::to_string(rows) + " rows, " + std::to_string(columns.size()) + " columns" + between + cycles;
  }
  std::string text = std::to_string(rows_differ) + " of " + std::to_string(rows) + " common rows differ";
  if (digest && rows_differ == 0) text += ", but ticks between them differ";
  if (rows_only_a > 0) text += ", " + std::to_string(rows_only_a) + " missing";
  if (rows_only_b > 0) text += ", " + std::to_string(rows_only_b) + " extra";
  if (!columns_only_a.empty()) text += ", " + std::to_string(columns_only_a.size()) + " columns missing";
  if (!columns_only_b.empty()) text += ", " + std::to_string(columns_only_b.size()) + " columns extra";
  return text;
}

std::string Comparison::verdict() const {
  return (equal() ? "PASS " : "FAIL ") + whole(a) + " and " + whole(b) + (equal() ? " are equal: " : " differ: ") +
         counts();
}

std::string Comparison::first_differences() const {
  std::string text;
  if (!columns_only_a.empty()) text += "  columns only in " + whole(a) + ": " + list(columns_only_a) + "\n";
  if (!columns_only_b.empty()) text += "  columns only in " + whole(b) + ": " + list(columns_only_b) + "\n";
  if (std::ranges::any_of(columns_only_a, is_digest) && std::ranges::any_of(columns_only_b, is_digest))
    text += "  the digests are of two versions of armature, so nothing is known of the ticks between the rows\n";
  append_only_in(text, rows_only_a, first_tick_only_a, whole(a));
  append_only_in(text, rows_only_b, first_tick_only_b, whole(b));
  if (first) {
    text += "  first mismatch at " + with_time(first->at) + ", " + first->column + ": " +
            value_text(a, first->value_a, first->at.line_a) + ", " + value_text(b, first->value_b, first->at.line_b) +
            "\n";
  }
  if (digest) text += digest_text(*this);
  return text;
}

std::size_t Comparison::deviating_columns() const {
  return static_cast<std::size_t>(std::ranges::count_if(columns, deviates));
}

std::string Comparison::deviations() const {
  std::string text;
  for (const ColumnDeviation& column : columns) {
    if (!deviates(column)) continue;
    if (text.empty()) text += "  largest deviation of each column:\n";
    text += "    " + column.column + ": " + column_text(column) + "\n";
  }
  return text;
}

}  // namespace armature::cosim
