#include "cosim/trace/compare.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "cosim/text/number_text.hpp"
#include "cosim/trace/csv_reader.hpp"

namespace armature::cosim {
namespace {

struct UnitTolerance {
  std::string_view suffix;
  double tolerance;
};
// One unit of the last of six digits, and half of one for the rounding of either file.
constexpr UnitTolerance kTolerances[] = {{"_deg", 1.5e-6}, {"_mm", 1.5e-6}};

struct ColumnPair {
  std::size_t a, b;
};

// Compares one value; returns |b - a|, and whether that is too much.
struct Deviation {
  double size = 0;
  bool bad = false;
};
Deviation deviation(const CsvReader& a, const CsvReader& b, ColumnPair at, std::optional<double> tolerance) {
  if (!tolerance) {
    const std::int64_t x = a.integer(at.a);
    const std::int64_t y = b.integer(at.b);
    return {std::fabs(static_cast<double>(y) - static_cast<double>(x)), x != y};
  }
  const double x = a.number(at.a);
  const double y = b.number(at.b);
  if (std::isnan(x) || std::isnan(y)) {
    const bool both = std::isnan(x) && std::isnan(y);
    return {both ? 0.0 : std::numeric_limits<double>::infinity(), !both};
  }
  const double size = std::fabs(y - x);
  return {size, !(size <= *tolerance)};
}

std::vector<ColumnPair> pair_columns(const CsvReader& a, const CsvReader& b, Comparison& result) {
  std::vector<ColumnPair> pairs;
  for (std::size_t i = 0; i < a.header().size(); ++i) {
    const std::string& name = a.header()[i];
    const auto twin = std::find(b.header().begin(), b.header().end(), name);
    if (twin == b.header().end()) {
      result.columns_only_a.push_back(name);
    } else {
      pairs.push_back({i, static_cast<std::size_t>(twin - b.header().begin())});
      ColumnDeviation column;
      column.column = name;
      column.tolerance = column_tolerance(name);
      result.columns.push_back(std::move(column));
    }
  }
  for (const std::string& name : b.header()) {
    if (std::find(a.header().begin(), a.header().end(), name) == a.header().end()) {
      result.columns_only_b.push_back(name);
    }
  }
  return pairs;
}

void compare_row(const CsvReader& a, const CsvReader& b, const std::vector<ColumnPair>& pairs, Comparison& result) {
  bool differs = false;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    ColumnDeviation& column = result.columns[i];
    const Deviation found = deviation(a, b, pairs[i], column.tolerance);
    if (found.size > column.largest) {
      column.largest = found.size;
      column.tick = a.tick();
    }
    if (!found.bad) continue;
    differs = true;
    ++column.rows;
    if (!result.first) {
      result.first = Mismatch{a.line(),
                              b.line(),
                              a.tick(),
                              column.column,
                              std::string{a.text(pairs[i].a)},
                              std::string{b.text(pairs[i].b)}};
    }
  }
  ++result.rows;
  if (differs) ++result.rows_differ;
}

std::string list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

void note_only(std::string& text, std::int64_t rows, std::optional<std::int64_t> first, const std::string& file) {
  if (rows == 0) return;
  text +=
      "  " + std::to_string(rows) + " rows only in " + file + ", the first at tick " + std::to_string(*first) + "\n";
}

}  // namespace

std::optional<double> column_tolerance(std::string_view column) {
  for (const UnitTolerance& unit : kTolerances) {
    if (column.ends_with(unit.suffix)) return unit.tolerance;
  }
  return std::nullopt;
}

Comparison compare_traces(const std::filesystem::path& file_a, const std::filesystem::path& file_b) {
  CsvReader a{file_a};
  CsvReader b{file_b};
  Comparison result;
  result.file_a = file_a.string();
  result.file_b = file_b.string();
  const std::vector<ColumnPair> pairs = pair_columns(a, b, result);
  bool more_a = a.next();
  bool more_b = b.next();
  while (more_a || more_b) {
    if (more_a && more_b && a.tick() == b.tick()) {
      compare_row(a, b, pairs, result);
      more_a = a.next();
      more_b = b.next();
    } else if (more_a && (!more_b || a.tick() < b.tick())) {
      if (result.rows_only_a++ == 0) result.first_tick_only_a = a.tick();
      more_a = a.next();
    } else {
      if (result.rows_only_b++ == 0) result.first_tick_only_b = b.tick();
      more_b = b.next();
    }
  }
  return result;
}

bool Comparison::equal() const {
  return rows_differ == 0 && rows_only_a == 0 && rows_only_b == 0 && columns_only_a.empty() && columns_only_b.empty();
}

std::string Comparison::verdict() const {
  if (equal()) {
    return "PASS " + file_b + " equals " + file_a + ": " + std::to_string(rows) + " rows, " +
           std::to_string(columns.size()) + " columns";
  }
  std::string text = "FAIL " + file_b + " differs from " + file_a + ": ";
  text += std::to_string(rows_differ) + " of " + std::to_string(rows) + " common rows differ";
  if (rows_only_a > 0) text += ", " + std::to_string(rows_only_a) + " missing";
  if (rows_only_b > 0) text += ", " + std::to_string(rows_only_b) + " extra";
  if (!columns_only_a.empty()) text += ", " + std::to_string(columns_only_a.size()) + " columns missing";
  if (!columns_only_b.empty()) text += ", " + std::to_string(columns_only_b.size()) + " columns extra";
  return text;
}

std::string Comparison::report() const {
  std::string text = verdict() + "\n";
  if (!columns_only_a.empty()) text += "  columns only in " + file_a + ": " + list(columns_only_a) + "\n";
  if (!columns_only_b.empty()) text += "  columns only in " + file_b + ": " + list(columns_only_b) + "\n";
  note_only(text, rows_only_a, first_tick_only_a, file_a);
  note_only(text, rows_only_b, first_tick_only_b, file_b);
  if (first) {
    text += "  first mismatch at tick " + std::to_string(first->tick) + ", " + first->column + ": " + first->value_a +
            " (line " + std::to_string(first->line_a) + ") against " + first->value_b + " (line " +
            std::to_string(first->line_b) + ")\n";
  }
  bool any = false;
  for (const ColumnDeviation& column : columns) {
    if (column.largest == 0) continue;
    if (!any) text += "  largest deviation of each column:\n";
    any = true;
    text += "    " + column.column + ": " +
            (column.tolerance ? fixed_text(column.largest, 6) : number_text(column.largest)) + " at tick " +
            std::to_string(column.tick) + ", " + std::to_string(column.rows) + " rows " +
            (column.tolerance ? "beyond " + number_text(*column.tolerance) : "differ") + "\n";
  }
  return text;
}

}  // namespace armature::cosim
