#include "cosim/cli/options/wave_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <utility>

#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/fabric/fst_converter.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {

void add_wave_options(CLI::App& command, WaveOptions& options) {
  CLI::Option* vcd = command.add_option("--vcd", options.vcd, "Write a VCD waveform of every signal to this file")
                         ->type_name(kFileValue);
  command.add_option("--fst", options.fst, "Write an FST waveform (fifty times smaller)")
      ->type_name(kFileValue)
      ->excludes(vcd);
  command.add_option("--from", options.from_s,
                     "Waveform and shown part of the report begin at this simulated time [s]");
  command.add_option("--to", options.to_s, "Waveform and shown part of the report end at this simulated time [s]");
  command
      .add_option_function<std::string>(
          "--wave-on", [&options](const std::string&) { options.on_fault = true; },
          "'fault': the waveform begins at the first fault and lasts 1 ms or until --to")
      ->check(CLI::IsMember({"fault"}));
}

void check_wave_options(const WaveOptions& options, bool report) {
  const bool wave = options.vcd || options.fst;
  for (const auto& [option, given] :
       {std::pair{"--from", options.from_s.has_value()}, std::pair{"--to", options.to_s.has_value()}}) {
    if (given && !wave && !report) throw CLI::ValidationError(option, "needs --vcd, --fst or --report");
  }
  if (options.on_fault && !wave) throw CLI::ValidationError("--wave-on", "needs --vcd or --fst");
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
  constexpr double kLeastRows = 40;
  const double from_s = options.from_s.value_or(0);
  const double to_s = options.to_s.value_or(scenario.duration_s);
  const double row_s = static_cast<double>(scenario.trace.every_ticks * kTickCycles) / static_cast<double>(kClkFreqHz);
  const double around_s = std::max(0.0, (kLeastRows * row_s - (to_s - from_s)) / 2);
  return ShownPart{.from_s = from_s - around_s, .to_s = to_s + around_s, .time_s = (from_s + to_s) / 2};
}

std::optional<WaveRequest> wave_request(const WaveOptions& options, double duration_s, OutputFiles& files) {
  const auto& file = options.vcd ? options.vcd : options.fst;
  if (!file) return std::nullopt;
  if (options.vcd) {
    files.writes(*file, "--vcd", Writing::kInPlace);
  } else {
    files.writes(*file, "--fst", Writing::kReplaced);
    files.writes(file->string() + ".hier", "--fst", Writing::kReplaced);  // a temporary file of the converter
  }
  if (options.fst && !fst_converter_available()) {
    throw InputError("--fst", "needs the program vcd2fst (Debian package gtkwave), which is not installed");
  }
  if (options.from_s && *options.from_s >= duration_s) {
    throw InputError("--from", "must be earlier than the end of the run, duration_s = " + number_text(duration_s));
  }
  WaveRequest request;
  request.file = *file;
  request.format = options.vcd ? WaveFormat::kVcd : WaveFormat::kFst;
  if (options.from_s) request.from = to_cycles(*options.from_s);
  if (options.to_s) request.to = to_cycles(std::min(*options.to_s, duration_s));
  request.on_fault = options.on_fault;
  return request;
}

std::string no_wave_text(const WaveRequest& wave) {
  const std::string from = wave.from ? " at or after --from" : "";
  return fmt::format("no waveform    {} is not written: {}\n", printable(wave.file.string(), kShowAll),
                     wave.on_fault ? "there was no fault" + from : "the run ended before --from");
}

}  // namespace armature::cosim
