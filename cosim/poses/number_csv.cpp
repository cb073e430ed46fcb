#include "cosim/poses/number_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cosim/text/blanks.hpp"
#include "cosim/text/byte_order_mark.hpp"
#include "cosim/text/csv_line.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/suggest.hpp"

namespace armature::cosim {
namespace {

constexpr std::size_t kMaxQuoted = 40;  // characters of the user's text in a message

struct Field {
  std::string_view text;  // without the blanks around it
  std::size_t at = 0;     // offset in the line
};

std::string quoted_text(std::string_view text) {
  return fmt::format("\"{}\"", printable(text, kMaxQuoted));
}

// A column as it was found. The file may be any file, such as one that a link leads to; its text is shown only if it
// looks like a header of ours.
std::string found_text(std::string_view found, std::span<const CsvLayout> layouts) {
  std::vector<std::string_view> names;
  for (const CsvLayout& layout : layouts) {
    for (const CsvColumn& column : layout) names.emplace_back(column.name);
  }
  const bool known = std::ranges::find(names, found) != names.end() || !nearest_name(found, names).empty() ||
                     parse_number(found).has_value();
  return known ? quoted_text(found) : "another text";
}

// Column of an offset in the line, from 1, in code points.
int column_of(std::string_view line, std::size_t at) {
  const auto starts = [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; };
  const std::string_view before = line.substr(0, at);
  return static_cast<int>(std::count_if(before.begin(), before.end(), starts)) + 1;
}

void trim(const CsvLine& line, std::vector<Field>& fields) {
  fields.clear();
  std::size_t begin = 0;
  for (const std::string_view value : line.values()) {
    const std::string_view text = trimmed(value);
    fields.push_back({text, begin + static_cast<std::size_t>(text.data() - value.data())});
    begin += value.size() + 1;
  }
}

std::size_t equal_columns(const std::vector<Field>& fields, const CsvLayout& layout) {
  std::size_t count = 0;
  while (count < std::min(fields.size(), layout.size()) && fields[count].text == layout[count].name) ++count;
  return count;
}

// The layout with this header. If there is none, reports where the header differs from the most similar layout.
std::optional<std::size_t> find_layout(std::string_view line, const std::vector<Field>& fields,
                                       std::span<const CsvLayout> layouts, CsvProblems& problems) {
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    const std::size_t equal = equal_columns(fields, layouts[i]);
    if (equal == fields.size() && equal == layouts[i].size()) return i;
    if (equal > equal_columns(fields, layouts[nearest])) nearest = i;
  }
  const CsvLayout& layout = layouts[nearest];
  const std::size_t equal = equal_columns(fields, layout);
  const std::string expected = equal < layout.size() ? quoted_text(layout[equal].name) : "the end of the line";
  const std::string found = equal < fields.size() ? found_text(fields[equal].text, layouts) : "the end of the line";
  const std::size_t at = equal < fields.size() ? fields[equal].at : line.size();
  std::string message = fmt::format("expected {}, found {}; the header is {}", expected, found, header_of(layouts[0]));
  for (const CsvLayout& other : layouts.subspan(1)) message += fmt::format(" or {}", header_of(other));
  problems.add(1, column_of(line, at), "header", std::move(message));
  return std::nullopt;
}

// Reads one row. Returns false and reports every problem if the row does not fit the layout.
bool read_row(std::string_view line, int number, const std::vector<Field>& fields, const CsvLayout& layout,
              std::vector<double>& values, CsvProblems& problems) {
  const std::size_t before = problems.count();
  if (fields.size() != layout.size()) {
    const bool empty = fields.size() == 1 && fields[0].text.empty();
    const std::size_t at = fields.size() > layout.size() ? fields[layout.size()].at : empty ? 0 : line.size();
    problems.add(number, column_of(line, at), {},
                 fmt::format("expected {} values as in the header, found {}", layout.size(),
                             empty ? "an empty line" : std::to_string(fields.size())));
    return false;
  }
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::optional<double> value = parse_number(fields[i].text);
    if (value && std::fabs(*value) <= layout[i].largest) {
      values[i] = *value;
      continue;
    }
    const std::string range =
        value ? fmt::format(" from {} to {}", number_text(-layout[i].largest), number_text(layout[i].largest)) : "";
    const std::string unit = layout[i].unit.empty() ? "" : fmt::format(" ({})", layout[i].unit);
    const std::string found = fields[i].text.empty() ? "nothing" : quoted_text(fields[i].text);
    problems.add(number, column_of(line, fields[i].at), layout[i].name,
                 fmt::format("expected a number{}{}, found {}", range, unit, found));
  }
  return problems.count() == before;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  if (text.starts_with('+') && text.size() > 1 && text[1] != '-') text.remove_prefix(1);
  const std::optional<double> value = parsed_number<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::string header_of(const CsvLayout& layout) {
  std::string text;
  for (const CsvColumn& column : layout) {
    if (!text.empty()) text += ',';
    text += column.name;
  }
  return text;
}

void CsvProblems::add(int line, int column, std::string_view key, std::string message) {
  if (++count_ > kMaxReported) return;
  kept_.push_back({file_, Origin{line, column, {}}, std::string{key}, std::move(message)});
}

void CsvProblems::throw_if_any() {
  if (count_ == 0) return;
  if (count_ > kMaxReported) {
    kept_.push_back({file_, Origin{}, {}, fmt::format("and {} more problems", count_ - kMaxReported)});
  }
  throw InputError{std::move(kept_)};
}

std::size_t read_number_csv(std::string_view text, const std::string& name, std::span<const CsvLayout> layouts,
                            const VisitRow& visit) {
  text = without_byte_order_mark(text);
  text = text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
  if (text.empty()) throw InputError{name, fmt::format("is empty, expected the header {}", header_of(layouts[0]))};

  CsvProblems problems{name};
  std::vector<Field> fields;
  CsvLine values_of_line{name};
  std::string_view line = pop_line(text);
  values_of_line.set(1, line);
  trim(values_of_line, fields);
  const std::optional<std::size_t> layout = find_layout(line, fields, layouts, problems);
  if (!layout) problems.throw_if_any();

  std::vector<double> values(layouts[*layout].size());
  std::vector<int> columns(values.size());
  int number = 1;
  for (std::size_t index = 0; !text.empty(); ++index) {
    line = pop_line(text);
    values_of_line.set(++number, line);
    trim(values_of_line, fields);
    if (!read_row(line, number, fields, layouts[*layout], values, problems)) continue;
    // The line has only numbers and blanks, so a byte is a code point.
    for (std::size_t i = 0; i < fields.size(); ++i) columns[i] = static_cast<int>(fields[i].at) + 1;
    visit({index, number, values, columns}, problems);
  }
  problems.throw_if_any();
  return *layout;
}

}  // namespace armature::cosim
