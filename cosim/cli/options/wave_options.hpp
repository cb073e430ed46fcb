// --vcd, --fst, --from, --to, --wave-on and --before of `armature run`: which waveform is written. `check` has the last
// two.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cosim/cli/options/output_files.hpp"
#include "cosim/page/report_page.hpp"
#include "cosim/rewind/wave_moment.hpp"
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
  std::optional<WaveReason> wave_on;
  std::optional<double> before_ms;  // only with wave_on
};

inline constexpr double kBeforeMs = 5;  // without --before

// `options` must outlive the parsing.
void add_wave_options(CLI::App& command, WaveOptions& options);
// --wave-on and --before only.
void add_moment_options(CLI::App& command, WaveOptions& options);

// Throws CLI::ValidationError for values that do not fit together. `report`: a report is written, too.
void check_wave_options(const WaveOptions& options, bool report);

// The part of a run that a report shows first: --from to --to, and what is around it if these are only a few rows of
// the trace. Nullopt without these options.
[[nodiscard]] std::optional<ShownPart> shown_part(const WaveOptions& options, const Scenario& scenario);

// The waveform of a run of `duration_s`. Nullopt if no option asks for one, or --wave-on does. Adds its files to
// `files`, which has the other files of this run. Throws InputError.
[[nodiscard]] std::optional<WaveRequest> wave_request(const WaveOptions& options, double duration_s,
                                                      OutputFiles& files);
// The same of --wave-on. Without --vcd and --fst the file is a failure_wave() in the folder `out`; one of an earlier
// run is removed.
[[nodiscard]] std::optional<MomentWaveRequest> moment_wave_request(const WaveOptions& options, double duration_s,
                                                                   const std::filesystem::path& out,
                                                                   OutputFiles& files);

// What --wave-on and --before ask for. Nullopt without --wave-on.
[[nodiscard]] std::optional<MomentWave> moment_wave(const WaveOptions& options);

// The waveform of a failure in the folder for the results.
[[nodiscard]] std::filesystem::path failure_wave(const std::filesystem::path& out, WaveFormat format);
// The format of a waveform of which the user names no file: FST if it can be converted.
[[nodiscard]] WaveFormat preferred_format();
// Removes the waveforms of failures from the folder. Throws std::filesystem_error.
void remove_failure_waves(const std::filesystem::path& out);

// Why the waveform that was asked for was not written. One line for the screen.
[[nodiscard]] std::string no_wave_text(const WaveRequest& wave);

}  // namespace armature::cosim
