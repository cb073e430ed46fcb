// The columns of a trace file: names, order and how a TraceRow becomes text.
//
//   tick, state             number of the trigger; MotionState: 0 idle, 1 moving, 2 stopping, 3 fault, 4 holding
//   jN_cmd_pulses           sum of all counts committed by the controller
//   jN_pin_pulses           net pulses seen on the step pins since reset
//   jN_enc_counts           encoder position as the controller read it
//   jN_corr_pulses          feedback correction that is in cmd_pulses
//   jN_ref_deg, jN_enc_deg  set-point of the next tick, and enc_counts as a joint angle; kFloatDigits after the point
//   tcp_ref_x_mm, .._y, .._z, tcp_enc_x_mm, ..  the tool centre point of both in the base frame; only in traces that
//                           ask for it
//
// All integer columns come first: their text is also what IntegerDigest hashes.
#pragma once

#include <cstddef>
#include <string>

#include "cosim/trace/trace_row.hpp"

namespace armature::cosim {

inline constexpr int kFloatDigits = 6;            // 1e-6 deg and 1e-6 mm, far below one pulse
inline constexpr std::size_t kMaxRowText = 2048;  // upper bound of what one append_* call writes

// Comma-separated names, no line end.
[[nodiscard]] std::string integer_header();
[[nodiscard]] std::string float_header();
[[nodiscard]] std::string tool_point_header();

// Write comma-separated values at `out` (room for kMaxRowText) and return the end; no line end. No locale, and the
// same text on every machine and compiler.
[[nodiscard]] char* append_integers(char* out, const TraceRow& row);
[[nodiscard]] char* append_floats(char* out, const TraceRow& row);
[[nodiscard]] char* append_tool_point(char* out, const TraceRow& row);  // nan for a row without

}  // namespace armature::cosim
