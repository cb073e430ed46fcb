// --vcd, --fst, --from, --to and --wave-on of `armature run`: which waveform is written.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cosim/cli/options/output_files.hpp"
#include "cosim/page/report_page.hpp"
#include "cosim/run/run.hpp"

namespace CLI {
class App;
}

namespace armature::cosim {

struct WaveOptions {
  std::optional<std::filesystem::path> vcd;  // at most one of the two
  std::optional<std::filesystem::path> fst;
  std::optional<double> from_s;  // simulated time
  std::optional<double> to_s;
  bool on_fault = false;  // --wave-on fault
};

// `options` must outlive the parsing.
void add_wave_options(CLI::App& command, WaveOptions& options);

// Throws CLI::ValidationError for values that do not fit together. `report`: a report is written, too.
void check_wave_options(const WaveOptions& options, bool report);

// The part of a run that a report shows first: --from to --to, and what is around it if these are only a few rows of
// the trace. Nullopt without these options.
[[nodiscard]] std::optional<ShownPart> shown_part(const WaveOptions& options, const Scenario& scenario);

// The waveform of a run of `duration_s`. Nullopt if no option asks for one. Adds its files to `files`, which has the
// other files of this run. Throws InputError.
[[nodiscard]] std::optional<WaveRequest> wave_request(const WaveOptions& options, double duration_s,
                                                      OutputFiles& files);

// Why the waveform that was asked for was not written. One line for the screen.
[[nodiscard]] std::string no_wave_text(const WaveRequest& wave);

}  // namespace armature::cosim
