// Goldens: golden.csv next to a scenario has some of its ticks, and [golden] the digest of the integers of every tick.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

inline constexpr std::int64_t kGoldenEveryTicks = 200;  // 100 Hz
inline constexpr const char* kGoldenFile = "golden.csv";

enum class GoldenVerdict : std::uint8_t { kNone, kEqual, kDiffers, kNotCompared };  // kNone: the scenario has no golden
// Simulated time [s].
struct TimeSpan {
  double from_s = 0, to_s = 0;
};

struct GoldenCheck {
  GoldenVerdict verdict = GoldenVerdict::kNone;
  std::string text;                  // the message, one line; may be empty
  std::string details;               // of kDiffers: lines that begin with two blanks, '\n' ended; no more than a few
  std::string columns{};             // of kDiffers: such lines, one for each column that deviates
  std::optional<TimeSpan> begins{};  // of kDiffers: when the difference begins; none: unknown

  [[nodiscard]] std::string_view word() const;  // `none`, `equal`, `differs`, `not compared`
};

// Path of the golden of a scenario; the file may not exist.
[[nodiscard]] std::filesystem::path golden_file(const Scenario& scenario);

// The scenario as an argument of `armature run`.
[[nodiscard]] std::string run_argument(const Scenario& scenario);

// Makes this run the scenario's golden: copies the trace and edits the digest in the scenario file. Returns a text of
// the changes, with the largest change of each column. `trace` is a trace file with every_ticks = kGoldenEveryTicks;
// messages do not name it. `sha256` is its IntegerDigest.
std::string bless_golden(const Scenario& scenario, const std::filesystem::path& trace, const std::string& sha256);

// Returns the text of a scenario file with golden.sha256 set. All other text, comments included, is unchanged. Adds the
// table when there is none. Throws InputError when this is not possible without changing another value.
[[nodiscard]] std::string with_golden_sha256(const std::string& text, const std::string& file,
                                             const std::string& sha256);

}  // namespace armature::cosim
