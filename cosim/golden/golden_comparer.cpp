#include "cosim/golden/golden_comparer.hpp"

#include <algorithm>
#include <memory>
#include <system_error>
#include <utility>

#include "cosim/text/input_error.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/shell_text.hpp"
#include "cosim/text/text_file.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {

GoldenComparer::GoldenComparer(const Scenario& scenario, ToolColumns tool_columns, TraceFile trace)
    : golden_{golden_file(scenario)},
      sha256_{scenario.golden.sha256},
      scenario_{run_argument(scenario)},
      tool_columns_{tool_columns},
      trace_{std::move(trace)},
      text_(kMaxRowText) {
  std::error_code ignored;
  if (!std::filesystem::exists(golden_, ignored)) return;
  try {
    require_regular_file(golden_);
    row_.emplace(trace_.file.string(), trace_header(tool_columns));
    comparer_.emplace(std::make_unique<CsvReader>(golden_),
                      TraceName{.file = printable(golden_.string(), kShowAll), .value = "golden"},
                      TraceName{.file = printable(trace_.file.string(), kShowAll), .value = "this run"},
                      row_->header());
  } catch (const InputError& error) {
    error_ = error.what();
  }
}

void GoldenComparer::add(const TraceRow& row, const IntegerDigest& digest) {
  if (ticks_++ == 0) first_cycle_ = row.cycle;
  if (!comparer_ || (row.tick % kGoldenEveryTicks != 0 && !comparer_->is_next(row.tick))) return;
  const char* const end = append_row(text_.data(), row, digest.prefix(), tool_columns_);
  constexpr int kFirstLine = 2;  // after the header
  const bool in_file = row.tick % trace_.every_ticks == 0;
  try {
    row_->set(in_file ? static_cast<int>(row.tick / trace_.every_ticks) + kFirstLine : 0, {text_.data(), end});
    comparer_->add(*row_);
  } catch (const InputError& error) {
    comparer_.reset();
    error_ = error.what();
  }
}

std::optional<TimeSpan> GoldenComparer::difference() const {
  if (!comparer_) return std::nullopt;
  const Comparison& so_far = comparer_->so_far();
  return so_far.first || so_far.digest ? begins(so_far) : std::nullopt;
}

GoldenCheck GoldenComparer::finish(const std::string& sha256) {
  const auto differs = [](std::string text) { return GoldenCheck{GoldenVerdict::kDiffers, std::move(text), {}}; };
  if (comparer_) {
    try {
      Comparison comparison = comparer_->finish();
      comparison.scenario = scenario_;
      if (sha256_) return check(comparison, sha256);
    } catch (const InputError& error) {
      error_ = error.what();
    }
  }
  if (!error_.empty()) return differs("it cannot be compared: " + error_);
  if (comparer_) return differs(printable(golden_.string(), kShowAll) + " exists but golden.sha256 is not set");
  if (sha256_) return differs("golden.sha256 is set but " + printable(golden_.string(), kShowAll) + " is missing");
  return {GoldenVerdict::kNone, "'armature bless " + shell_word(scenario_) + "' makes this run the golden", {}};
}

std::optional<TimeSpan> GoldenComparer::begins(const Comparison& comparison) const {
  // If all rows of the golden are equal, the difference is after them.
  std::int64_t last = std::min(comparison.last_tick + kGoldenEveryTicks, ticks_ - 1);
  if (comparison.digest) last = comparison.digest->until.tick;
  if (comparison.first) last = std::min(last, comparison.first->at.tick);
  if (last <= 0) return std::nullopt;
  const std::int64_t equal = std::max<std::int64_t>(comparison.last_equal_tick, 0);
  const auto time_s = [this](std::int64_t tick) { return to_seconds(Cycles{first_cycle_ + tick * kTickCycles}); };
  return TimeSpan{.from_s = time_s(equal), .to_s = time_s(last)};
}

GoldenCheck GoldenComparer::check(const Comparison& comparison, const std::string& sha256) const {
  GoldenCheck check{GoldenVerdict::kDiffers, {}, {}};
  check.begins = begins(comparison);
  if (comparison.equal_but_for_version()) {
    check.text = printable(golden_.string(), kShowAll) + ": its " + std::to_string(comparison.rows) +
                 " rows are equal, but its digest is that of an earlier version of armature";
    check.details = "  'armature bless " + shell_word(scenario_) + "' renews it\n";
    check.begins.reset();
    return check;
  }
  if (!comparison.equal()) {
    check.text = printable(golden_.string(), kShowAll) + ": " + comparison.counts();
    check.details = comparison.first_differences();
    check.columns = comparison.deviations();
    if (const std::size_t columns = comparison.deviating_columns(); columns > 0) {
      check.details += "  columns that deviate: " + std::to_string(columns) + "; each of them: armature compare " +
                       shell_word(golden_.string()) + " " + shell_word(trace_.file.string()) + "\n";
    }
    return check;
  }
  if (sha256 != *sha256_ && comparison.other_cycles) {
    check.text = printable(golden_.string(), kShowAll) + ": its " + std::to_string(comparison.rows) +
                 " rows are equal, but the triggers come at other clock cycles";
    return check;
  }
  if (sha256 != *sha256_) {
    check.text = "the run differs after the last row of " + printable(golden_.string(), kShowAll) + ", tick " +
                 std::to_string(comparison.last_tick) + ", or golden.sha256 is that of another golden";
    check.details = "  golden.sha256: " + *sha256_ + "\n  this run:      " + sha256 + "\n";
    if (comparison.last_tick + 1 < ticks_) {
      check.details += "  these ticks:   " + show_ticks_command(scenario_, comparison.last_tick + 1, ticks_ - 1) + "\n";
    }
    return check;
  }
  check.verdict = GoldenVerdict::kEqual;
  check.begins.reset();
  check.text = std::to_string(comparison.rows) + " rows, and the digest of all " + std::to_string(ticks_) + " ticks";
  return check;
}

}  // namespace armature::cosim
