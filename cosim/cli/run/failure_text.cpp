#include "cosim/cli/run/failure_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "cosim/cli/options/wave_options.hpp"
#include "cosim/golden/golden.hpp"
#include "cosim/run/engine_waves.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/shell_text.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

constexpr double kAroundS = 0.0002;  // shown before and after a failure: four ticks
constexpr double kBeforeS = 0.001;   // shown before an expectation fails, if the golden differs by then
constexpr double kLongestVcdS = 0.002;
constexpr int kDigits = 6;  // of a time in a command

TimeSpan around(double from_s, double to_s) {
  return {.from_s = std::max(from_s - kAroundS, 0.0), .to_s = to_s + kAroundS};
}

// When the run first went wrong. Nothing if no moment is to blame, as for the position at the end. The rows of a golden
// tell only roughly where it begins to differ. If an expectation fails there, its moment and what came just before it
// are shown.
std::optional<TimeSpan> failure_span(const RunSummary& summary) {
  if (summary.failure) {
    const double end_s = to_seconds(summary.facts.cycles);
    return around(end_s, end_s);
  }
  std::optional<double> failed_s;
  for (const ExpectFailure& failure : summary.expect_failures) {
    if (!failure.where.at) continue;
    const double at_s = to_seconds(failure.where.at->at);
    failed_s = std::min(failed_s.value_or(at_s), at_s);
  }
  const std::optional<TimeSpan>& golden = summary.golden.begins;
  if (!golden && !failed_s) return std::nullopt;
  if (!golden || (failed_s && *failed_s <= golden->from_s)) return around(*failed_s, *failed_s);
  if (!failed_s || *failed_s > golden->to_s + kAroundS) return around(golden->from_s, golden->to_s);
  return around(std::max(golden->from_s, *failed_s - kBeforeS), *failed_s);
}

// A VCD file grows by about 20 MB in a millisecond.
std::string wave_option(const TimeSpan& span, const std::string& out) {
  const WaveFormat format = span.to_s - span.from_s > kLongestVcdS ? preferred_format() : WaveFormat::kVcd;
  return (format == WaveFormat::kVcd ? " --vcd " : " --fst ") + shell_word(failure_wave(out, format).string());
}

}  // namespace

std::string failure_reasons(const Scenario& scenario, const RunSummary& summary) {
  std::string text;
  if (summary.failure) text += *summary.failure + '\n';
  for (const ExpectFailure& failure : summary.expect_failures) text += failure.text() + '\n';
  const GoldenCheck& golden = summary.golden;
  if (golden.verdict == GoldenVerdict::kDiffers) text += "golden differs: " + golden.text + '\n' + golden.details;
  if (golden.verdict == GoldenVerdict::kNone)
    text += "no " + printable(golden_file(scenario).string(), kShowAll) + '\n';
  return text;
}

NextCommand next_command(const Scenario& scenario, const RunSummary& summary, const std::string& out,
                         const std::vector<std::string>& options) {
  const std::string name = shell_word(run_argument(scenario));
  if (summary.golden.verdict == GoldenVerdict::kNone && summary.passed())
    return {"to make this run the golden", "armature bless " + name};
  std::string command = "armature run " + name;
  for (const std::string& option : options) command += " " + shell_word(option);
  command += " --report";
  if (const auto span = failure_span(summary)) {
    command += wave_option(*span, out) + " --from " + fixed_text(span->from_s, kDigits) + " --to " +
               fixed_text(span->to_s, kDigits);
  }
  return {"to see it", std::move(command)};
}

std::string engine_waves_text(const RunSummary& summary, const std::filesystem::path& folder) {
  if (!summary.engine_waves_written) return {};
  return fmt::format("waveforms      {}, {}: both engines around cycle {}\n",
                     printable((folder / kRtlWaveFile).string(), kShowAll),
                     printable((folder / kModelWaveFile).string(), kShowAll), summary.engines_differ_at->value());
}

NextCommand compare_engines_command(const std::filesystem::path& folder) {
  return {"to see it", fmt::format("armature compare {} {} --views {}", shell_word((folder / kRtlWaveFile).string()),
                                   shell_word((folder / kModelWaveFile).string()), shell_word(folder.string()))};
}

}  // namespace armature::cosim
