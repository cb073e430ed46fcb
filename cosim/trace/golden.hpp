// Goldens: golden.csv beside a scenario (every 20th tick) and the digest of the full-rate integers in its [golden].
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

inline constexpr std::int64_t kGoldenEveryTicks = 20;  // 1 kHz
inline constexpr const char* kGoldenFile = "golden.csv";

enum class GoldenVerdict : std::uint8_t { kNone, kEqual, kDiffers, kNotCompared };  // kNone: the scenario has no golden
struct GoldenCheck {
  GoldenVerdict verdict = GoldenVerdict::kNone;
  std::string text;     // what is to be said about it, one line; empty: nothing
  std::string details;  // of kDiffers: lines that begin with two blanks, '\n' ended
  std::string command;  // of kDiffers: what shows the difference, of a run at the rate of goldens; empty: nothing does

  [[nodiscard]] std::string_view word() const;  // `none`, `equal`, `differs`, `not compared`
};

// Where the golden of a scenario is, or would be.
[[nodiscard]] std::filesystem::path golden_file(const Scenario& scenario);

// The scenario as `armature run` takes it.
[[nodiscard]] std::string run_argument(const Scenario& scenario);

// Makes this run the scenario's golden: copies the trace, edits the digest in the scenario file. Returns what changed,
// with the largest change of each column. `trace` is a trace file with every_ticks = kGoldenEveryTicks that messages do
// not name, `sha256` its IntegerDigest.
std::string bless_golden(const Scenario& scenario, const std::filesystem::path& trace, const std::string& sha256);

// The text of a scenario file with golden.sha256 set and everything else, comments included, as it was. Adds the table
// when there is none. Throws InputError when that cannot be done without changing the meaning of something else.
[[nodiscard]] std::string with_golden_sha256(const std::string& text, const std::string& file,
                                             const std::string& sha256);

}  // namespace armature::cosim
