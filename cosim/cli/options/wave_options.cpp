#include "cosim/cli/options/wave_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>
#include <vector>

#include "controller/base/words.hpp"
#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/fabric/fst_converter.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

constexpr double kMaxBeforeMs = 1000;

std::optional<WaveOutput> named_output(const WaveOptions& options) {
  if (options.vcd) return WaveOutput{.file = *options.vcd, .format = WaveFormat::kVcd};
  if (options.fst) return WaveOutput{.file = *options.fst, .format = WaveFormat::kFst};
  return std::nullopt;
}

void claim(const WaveOutput& output, const char* option, OutputFiles& files) {
  if (output.format == WaveFormat::kVcd) {
    files.writes(output.file, option, Writing::kInPlace);
    return;
  }
  files.writes(output.file, option, Writing::kReplaced);
  files.writes(output.file.string() + ".hier", option, Writing::kReplaced);  // a temporary file of the converter
  if (!fst_converter_available()) {
    throw InputError("--fst", "needs the program vcd2fst (Debian package gtkwave), which is not installed");
  }
}

struct WindowTimes {
  std::optional<Cycles> from, to;
};

WindowTimes window_times(const WaveOptions& options, double duration_s) {
  if (options.from_s && *options.from_s >= duration_s) {
    throw InputError("--from", "must be earlier than the end of the run, duration_s = " + number_text(duration_s));
  }
  WindowTimes times;
  if (options.from_s) times.from = to_cycles(*options.from_s);
  if (options.to_s) times.to = to_cycles(std::min(*options.to_s, duration_s));
  return times;
}

}  // namespace

void add_wave_options(CLI::App& command, WaveOptions& options) {
  CLI::Option* vcd = command.add_option("--vcd", options.vcd, "Write a VCD waveform of every signal to this file")
                         ->type_name(kFileValue);
  command.add_option("--fst", options.fst, "Write an FST waveform (fifty times smaller)")
      ->type_name(kFileValue)
      ->excludes(vcd);
  command.add_option("--from", options.from_s,
                     "Waveform and shown part of the report begin at this simulated time [s]");
  command.add_option("--to", options.to_s, "Waveform and shown part of the report end at this simulated time [s]");
  add_moment_options(command, options);
}

void add_moment_options(CLI::App& command, WaveOptions& options) {
  const auto& words = kWordsOf<WaveReason>;
  command
      .add_option_function<std::string>(
          "--wave-on", [&options](const std::string& word) { options.wave_on = enumerator_of<WaveReason>(word); },
          "Write the waveform of the milliseconds before and after a moment: 'fault', the controller reports its first "
          "fault; 'fail', an expectation fails; 'mismatch', the run begins to differ from its golden")
      ->check(CLI::IsMember(std::vector<std::string>(words.begin(), words.end())));
  command.add_option("--before", options.before_ms,
                     fmt::format("The waveform of --wave-on begins so long before the moment [ms] (default {})",
                                 number_text(kBeforeMs)));
}

void check_wave_options(const WaveOptions& options, bool report) {
  const bool wave = options.vcd || options.fst || options.wave_on;
  for (const auto& [option, given] :
       {std::pair{"--from", options.from_s.has_value()}, std::pair{"--to", options.to_s.has_value()}}) {
    if (given && !wave && !report) throw CLI::ValidationError(option, "needs --vcd, --fst, --wave-on or --report");
  }
  if (options.before_ms && !options.wave_on) throw CLI::ValidationError("--before", "needs --wave-on");
  if (options.before_ms && !(*options.before_ms >= 0 && *options.before_ms <= kMaxBeforeMs)) {
    throw CLI::ValidationError("--before", "must be a time of 0 to " + number_text(kMaxBeforeMs) + " ms");
  }
  for (const auto& [option, time_s] : {std::pair{"--from", options.from_s}, std::pair{"--to", options.to_s}}) {
    if (time_s && !(std::isfinite(*time_s) && *time_s >= 0)) {
      throw CLI::ValidationError(option, "must be a time from 0 on, in seconds");
    }
  }
  if (options.from_s && options.to_s && *options.to_s <= *options.from_s) {
    throw CLI::ValidationError("--to", "must be later than --from");
  }
}

std::optional<ShownPart> shown_part(const WaveOptions& options, const Scenario& scenario) {
  if (!options.from_s && !options.to_s) return std::nullopt;
  constexpr double kFewestRows = 40;
  const double from_s = options.from_s.value_or(0);
  const double to_s = options.to_s.value_or(scenario.duration_s);
  const double row_s = static_cast<double>(scenario.trace.every_ticks * kTickCycles) / static_cast<double>(kClkFreqHz);
  const double around_s = std::max(0.0, (kFewestRows * row_s - (to_s - from_s)) / 2);
  return ShownPart{.from_s = from_s - around_s, .to_s = to_s + around_s, .time_s = (from_s + to_s) / 2};
}

std::optional<WaveRequest> wave_request(const WaveOptions& options, double duration_s, OutputFiles& files) {
  if (options.wave_on) return std::nullopt;
  const std::optional<WaveOutput> output = named_output(options);
  if (!output) return std::nullopt;
  claim(*output, output->format == WaveFormat::kVcd ? "--vcd" : "--fst", files);
  const WindowTimes times = window_times(options, duration_s);
  return WaveRequest{.file = output->file, .format = output->format, .from = times.from, .to = times.to};
}

std::optional<MomentWaveRequest> moment_wave_request(const WaveOptions& options, double duration_s,
                                                     const std::filesystem::path& out, OutputFiles& files) {
  const std::optional<MomentWave> wanted = moment_wave(options);
  if (!wanted) return std::nullopt;
  MomentWaveRequest request{*wanted, {}};
  if (const std::optional<WaveOutput> named = named_output(options)) {
    request.output = *named;
  } else {
    remove_failure_waves(out);
    request.output = {.file = failure_wave(out, preferred_format()), .format = preferred_format()};
  }
  claim(request.output, "--wave-on", files);
  const WindowTimes times = window_times(options, duration_s);
  request.wanted.from = times.from;
  request.wanted.to = times.to;
  return request;
}

std::optional<MomentWave> moment_wave(const WaveOptions& options) {
  if (!options.wave_on) return std::nullopt;
  return MomentWave{.reason = *options.wave_on, .before = to_cycles(options.before_ms.value_or(kBeforeMs) * 1e-3)};
}

std::filesystem::path failure_wave(const std::filesystem::path& out, WaveFormat format) {
  return out / (format == WaveFormat::kVcd ? "failure.vcd" : "failure.fst");
}

WaveFormat preferred_format() {
  return fst_converter_available() ? WaveFormat::kFst : WaveFormat::kVcd;
}

void remove_failure_waves(const std::filesystem::path& out) {
  for (const WaveFormat format : {WaveFormat::kVcd, WaveFormat::kFst}) {
    const std::filesystem::path file = failure_wave(out, format);
    std::error_code ignored;
    if (std::filesystem::is_regular_file(std::filesystem::symlink_status(file, ignored))) std::filesystem::remove(file);
  }
}

std::string no_wave_text(const WaveRequest& wave) {
  return fmt::format("no waveform    {} is not written: the run ended before --from\n",
                     printable(wave.file.string(), kShowAll));
}

}  // namespace armature::cosim
