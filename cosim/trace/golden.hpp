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

enum class GoldenVerdict { kNone, kEqual, kDiffers };  // kNone: the scenario has no golden
struct GoldenCheck {
  GoldenVerdict verdict = GoldenVerdict::kNone;
  std::string verdict_line;  // PASS, FAIL or NONE and why, no line end
  std::string report;        // all lines, the verdict line first
};

// `trace` is a trace file of this run with every_ticks = kGoldenEveryTicks, `sha256` its IntegerDigest.
[[nodiscard]] GoldenCheck check_golden(const Scenario& scenario, const std::filesystem::path& trace,
                                       const std::string& sha256);

// Makes this run the scenario's golden: copies the trace, edits the digest in the scenario file. Returns what changed,
// with the largest change of each column.
std::string bless_golden(const Scenario& scenario, const std::filesystem::path& trace, const std::string& sha256);

// The text of a scenario file with golden.sha256 set and everything else, comments included, as it was. Adds the table
// when there is none. Throws InputError when that cannot be done without changing the meaning of something else.
[[nodiscard]] std::string with_golden_sha256(const std::string& text, const std::string& file,
                                             const std::string& sha256);

}  // namespace armature::cosim
