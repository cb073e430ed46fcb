#include "cosim/recording/trace_table.hpp"

#include <algorithm>
#include <cmath>

#include "cosim/text/input_error.hpp"
#include "cosim/trace/columns.hpp"
#include "cosim/trace/csv_reader.hpp"

namespace armature::cosim {
namespace {

constexpr int kUnknownDigits = -1;  // digits of a column without a number so far

struct Cell {
  std::int64_t value = 0;
  int digits = 0;
};

// The exact value of a decimal text. CsvRow has checked that it is a number; the writer uses no exponents.
Cell cell_of(std::string_view text) {
  constexpr std::size_t kMaxDigits = 18;  // always fit an int64
  Cell cell;
  bool point = false;
  std::size_t digits = 0;
  for (const char c : text) {
    if (c == '.') {
      point = true;
    } else if (c >= '0' && c <= '9' && ++digits <= kMaxDigits) {
      cell.value = cell.value * 10 + (c - '0');
      cell.digits += point ? 1 : 0;
    }
  }
  if (text.starts_with('-')) cell.value = -cell.value;
  return cell;
}

std::int64_t ten_to(int exponent) {
  std::int64_t power = 1;
  for (int i = 0; i < exponent; ++i) power *= 10;
  return power;
}

// Appends the value of this field. All values of a column have the number of digits of the first one.
void append_value(NumberColumn& column, const CsvRow& row, std::size_t field) {
  if (std::isnan(row.number(field))) {
    column.values.push_back(NumberColumn::kNone);
    return;
  }
  const Cell cell = cell_of(row.text(field));
  if (column.digits == kUnknownDigits) column.digits = cell.digits;
  const int more = column.digits - cell.digits;
  column.values.push_back(more >= 0 ? cell.value * ten_to(more) : cell.value / ten_to(-more));
}

}  // namespace

double NumberColumn::number(std::size_t row) const {
  if (values[row] == kNone) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(values[row]) / static_cast<double>(ten_to(digits));
}

const NumberColumn* TraceTable::find(std::string_view name) const {
  const auto found = std::ranges::find(columns, name, &NumberColumn::name);
  return found == columns.end() ? nullptr : &*found;
}

const NumberColumn& TraceTable::column(std::string_view name) const {
  const NumberColumn* const found = find(name);
  if (found == nullptr) throw InputError{file, "has no column '" + std::string{name} + "'"};
  return *found;
}

TraceTable read_trace_table(const std::filesystem::path& file) {
  CsvReader reader{file};
  TraceTable table{.file = file.string()};
  const std::vector<std::string>& header = reader.header();
  std::vector<std::size_t> fields;  // of table.columns
  std::size_t state = header.size();
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (header[i] == kStateColumn) {
      state = i;
    } else if (!is_digest(header[i])) {
      fields.push_back(i);
      table.columns.push_back({.name = header[i], .digits = kUnknownDigits});
    }
  }
  while (reader.next()) {
    const CsvRow& row = reader.row();
    if (state < header.size() && (table.states.empty() || table.states.back().state != row.text(state))) {
      table.states.push_back({std::string{row.text(state)}, table.rows()});
    }
    for (std::size_t i = 0; i < fields.size(); ++i) append_value(table.columns[i], row, fields[i]);
  }
  for (NumberColumn& column : table.columns) column.digits = std::max(column.digits, 0);
  if (table.rows() == 0) throw InputError{table.file, "has no rows"};
  return table;
}

}  // namespace armature::cosim
