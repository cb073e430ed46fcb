// The columns of a trace file: names, order and how a TraceRow becomes text. scenarios/RESULTS.md describes their
// meaning.
//
//   tick, time_s, state, the integers of each axis, the angles of each axis, the tool point if requested, digest2
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "controller/base/units.hpp"
#include "cosim/trace/trace_row.hpp"

namespace armature::cosim {

inline constexpr std::string_view kTickColumn = "tick";
inline constexpr std::string_view kTimeColumn = "time_s";
inline constexpr std::string_view kStateColumn = "state";
// IntegerDigest. The number is its version: digests of two versions have nothing in common.
inline constexpr std::string_view kDigestColumn = "digest2";
// Whether the column has digests of any version.
[[nodiscard]] bool is_digest(std::string_view column);

inline constexpr int kSetPointDigits = 9;          // second differences at 20 kHz are exact to 1 deg/s^2 or mm/s^2
inline constexpr int kMeasuredDigits = 6;          // 1e-6 deg and 1e-6 mm, far below one count
inline constexpr int kTimeDigits = 8;              // exact: seconds_text()
inline constexpr std::size_t kMaxPartText = 2048;  // upper bound of the text of one append_* call for a part of a row
inline constexpr std::size_t kMaxRowText = 4 * kMaxPartText;  // of append_row

enum class ToolColumns : bool { kNo, kYes };

// Comma-separated names, no line end.
[[nodiscard]] std::string integer_header();  // with the state
[[nodiscard]] std::string float_header();
[[nodiscard]] std::string tool_point_header();
[[nodiscard]] std::string trace_header(ToolColumns tool_columns);  // of a whole row

// Write comma-separated values at `out` and return the end; no line end. No locale, and the same text on every machine
// and compiler.
[[nodiscard]] char* append_integers(char* out, const TraceRow& row);
[[nodiscard]] char* append_floats(char* out, const TraceRow& row);
[[nodiscard]] char* append_tool_point(char* out, const TraceRow& row);  // nan for a row without a tool point
// Simulated time [s] with kTimeDigits, as seconds_text().
[[nodiscard]] char* append_seconds(char* out, Cycles cycles);
// A whole row. `digest` is IntegerDigest::prefix() after this row.
[[nodiscard]] char* append_row(char* out, const TraceRow& row, std::string_view digest, ToolColumns tool_columns);

}  // namespace armature::cosim
