#include "cosim/trace/compare.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cosim/time/clock.hpp"
#include "cosim/trace/columns.hpp"

namespace armature::cosim {
namespace {

struct NamedRule {
  std::string_view suffix;
  ColumnRule rule;
};
using Kind = ColumnRule::Kind;
// Angles and positions: one unit of the sixth digit, and half a unit for the rounding. Times: half a tick,
// because rows are paired by tick and the start of the timer may depend on the bus.
constexpr double kTolerance = 1.5e-6;
constexpr double kTimeTolerance = 0.5 * static_cast<double>(kTickCycles) / kClkFreqHz;
constexpr NamedRule kRules[] = {
    {"_deg", {Kind::kReal, kTolerance, kMeasuredDigits}},
    {"_mm", {Kind::kReal, kTolerance, kMeasuredDigits}},
    {kTimeColumn, {Kind::kReal, kTimeTolerance, kTimeDigits}},
    {kStateColumn, {Kind::kText}},
};

// Whether the text is a number that needs no other check: a few digits, for reals with a point between them.
bool is_plain(std::string_view text, Kind kind) {
  constexpr std::size_t kMaxDigits = 18;
  if (text.starts_with('-')) text.remove_prefix(1);
  std::size_t points = 0;
  for (const char c : text) {
    if (c == '.') {
      ++points;
    } else if (c < '0' || c > '9') {
      return false;
    }
  }
  return text.size() <= kMaxDigits && points <= (kind == Kind::kReal ? 1U : 0U) && !text.empty() &&
         text.front() != '.' && text.back() != '.';
}

// |b - a|, and whether it is beyond the tolerance. The size of text is 0.
struct Deviation {
  double size = 0;
  bool bad = false;
};
Deviation deviation(const CsvRow& a, std::size_t at_a, const CsvRow& b, std::size_t at_b, const ColumnRule& rule) {
  const bool same = a.text(at_a) == b.text(at_b);
  if (rule.kind == Kind::kText) return {0, !same};
  // Most values are equal, and a conversion costs more than a look at their digits.
  if (same && is_plain(a.text(at_a), rule.kind)) return {};
  if (rule.kind == Kind::kInteger) {
    const std::int64_t x = a.integer(at_a);
    const std::int64_t y = b.integer(at_b);
    return {std::fabs(static_cast<double>(y) - static_cast<double>(x)), x != y};
  }
  const double x = a.number(at_a);
  const double y = b.number(at_b);
  // NaN is not equal to any value, not even to NaN.
  if (std::isnan(x) || std::isnan(y)) return {std::numeric_limits<double>::infinity(), true};
  const double size = std::fabs(y - x);
  return {size, !(size <= rule.tolerance)};
}

std::optional<std::size_t> find(const std::vector<std::string>& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

}  // namespace

void RowGrid::add(std::int64_t tick) {
  if (rows_ == 0) first_ = tick;
  if (rows_ == 1) interval_ = tick - first_;
  ++rows_;
}

bool RowGrid::skips(std::int64_t tick, const RowGrid& other) const {
  if (rows_ < 2 || other.rows_ < 2) return false;
  return interval_ > other.interval_ && interval_ % other.interval_ == 0 && (tick - first_) % interval_ != 0;
}

ColumnRule column_rule(std::string_view column) {
  if (is_digest(column)) return {Kind::kText};
  for (const NamedRule& named : kRules) {
    const bool unit = named.suffix.starts_with('_');
    if (unit ? column.ends_with(named.suffix) : column == named.suffix) return named.rule;
  }
  return {};
}

TraceComparer::TraceComparer(std::unique_ptr<CsvReader> trace_a, TraceName a, TraceName b,
                             const std::vector<std::string>& columns_b)
    : a_{std::move(trace_a)} {
  result_.a = std::move(a);
  result_.b = std::move(b);
  pair_columns(a_->header(), columns_b);
  next_a();
}

void TraceComparer::pair_columns(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::optional<std::size_t> twin = find(b, a[i]);
    if (!twin) {
      result_.columns_only_a.push_back(a[i]);
      continue;
    }
    if (is_digest(a[i])) digest_ = pairs_.size();
    pairs_.push_back({i, *twin});
    ColumnDeviation column;
    column.column = a[i];
    column.rule = column_rule(a[i]);
    result_.columns.push_back(std::move(column));
  }
  for (const std::string& name : b) {
    if (!find(a, name)) result_.columns_only_b.push_back(name);
  }
  time_a_ = find(a, kTimeColumn);
  time_b_ = find(b, kTimeColumn);
}

RowPosition TraceComparer::position_of(const CsvRow& a, const CsvRow& b) const {
  RowPosition position{.tick = a.tick(), .time_s = std::nullopt, .line_a = a.line(), .line_b = b.line()};
  if (time_a_) {
    position.time_s = a.number(*time_a_);
  } else if (time_b_) {
    position.time_s = b.number(*time_b_);
  }
  return position;
}

void TraceComparer::compare_rows(const CsvRow& a, const CsvRow& b) {
  const RowPosition here = position_of(a, b);
  bool differs = false;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (i == digest_) continue;
    ColumnDeviation& column = result_.columns[i];
    const auto [at_a, at_b] = pairs_[i];
    const Deviation found = deviation(a, at_a, b, at_b, column.rule);
    const bool first_text = column.rule.kind == Kind::kText && found.bad && column.rows == 0;
    if (found.size > column.largest || first_text) {
      column.largest = found.size;
      column.tick = here.tick;
    }
    if (!found.bad) continue;
    differs = true;
    ++column.rows;
    if (!result_.first) {
      result_.first = Mismatch{here, column.column, std::string{a.text(at_a)}, std::string{b.text(at_b)}};
    }
  }
  compare_digest(a, b, here);
  ++result_.rows;
  if (differs) ++result_.rows_differ;
  result_.last_tick = here.tick;
  if (!result_.first && !result_.digest) result_.last_equal_tick = here.tick;
  before_ = here;
}

void TraceComparer::compare_digest(const CsvRow& a, const CsvRow& b, const RowPosition& here) {
  if (!digest_ || a.text(pairs_[*digest_].a) == b.text(pairs_[*digest_].b)) return;
  if (time_a_ && time_b_ && a.text(*time_a_) != b.text(*time_b_)) result_.other_cycles = true;
  if (result_.other_cycles) return;
  if (!result_.digest) result_.digest = DigestMismatch{.after = before_, .until = here};
  ++result_.digest->rows;
}

void TraceComparer::next_a() {
  more_a_ = a_->next();
  if (more_a_) grid_a_.add(a_->row().tick());
}

void TraceComparer::skip_a() {
  const std::int64_t tick = a_->row().tick();
  if (grid_b_.skips(tick, grid_a_)) {
    ++result_.rows_between;
  } else if (result_.rows_only_a++ == 0) {
    result_.first_tick_only_a = tick;
  }
  next_a();
}

void TraceComparer::add(const CsvRow& b) {
  grid_b_.add(b.tick());
  while (more_a_ && a_->row().tick() < b.tick()) skip_a();
  if (is_next(b.tick())) {
    compare_rows(a_->row(), b);
    next_a();
  } else if (grid_a_.skips(b.tick(), grid_b_)) {
    ++result_.rows_between;
  } else if (result_.rows_only_b++ == 0) {
    result_.first_tick_only_b = b.tick();
  }
}

Comparison TraceComparer::finish() {
  while (more_a_) skip_a();
  return std::move(result_);
}

Comparison compare_traces(const std::filesystem::path& a, const std::filesystem::path& b, TraceName name_a,
                          TraceName name_b) {
  auto reference = std::make_unique<CsvReader>(a);
  CsvReader reader{b};
  TraceComparer comparer{std::move(reference), std::move(name_a), std::move(name_b), reader.header()};
  while (reader.next()) comparer.add(reader.row());
  return comparer.finish();
}

Comparison compare_traces(const std::filesystem::path& a, const std::filesystem::path& b) {
  return compare_traces(a, b, {.file = a.string()}, {.file = b.string()});
}

}  // namespace armature::cosim
