// The first difference of two waveforms in the part of time and in the signals that both have.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "controller/base/units.hpp"
#include "cosim/waves/wave_reader.hpp"

namespace armature::cosim {

struct SignalDifference {
  WaveSignal signal;
  std::string value_a, value_b;  // as WaveReader::value()
};

// The first time at which a signal differs.
struct WaveDifference {
  std::int64_t at_ps = 0;
  std::optional<std::int64_t> tick_a, tick_b;  // of the software then; none: the file does not have it
  std::vector<SignalDifference> signals;       // all that differ at this time, in the order of file a
};

struct WaveComparison {
  std::string a, b;                                    // files
  std::int64_t unit_a_ps = 1, unit_b_ps = 1;           // of time in the files
  std::optional<std::int64_t> begin_a_ps, begin_b_ps;  // first times of the files; none: the file has no time
  std::int64_t from_ps = 0, to_ps = 0;                 // compared, both included, up to the first difference
  bool common_time = true;                  // false: one file ends, at to_ps, before the other one begins, at from_ps
  std::size_t signals = 0;                  // in both
  std::vector<std::string> only_a, only_b;  // names with range
  std::optional<WaveDifference> first;

  [[nodiscard]] bool comparable() const { return common_time && signals > 0; }
  // What cannot be compared is not equal.
  [[nodiscard]] bool equal() const { return comparable() && !first; }
  // `PASS a.vcd and b.vcd are equal: ...` or `FAIL ...`, then lines that begin with two blanks; each ends with '\n'.
  [[nodiscard]] std::string report() const;
};

// The clock cycle at this time of a waveform. A cycle begins with its rising edge.
[[nodiscard]] Cycles wave_cycle(std::int64_t ps);

// Whether the value is ASCII: a text that the software wrote.
[[nodiscard]] bool is_wave_text(const WaveSignal& signal);

// The value as messages show it: 0x2A, or the text in quotes.
[[nodiscard]] std::string wave_value_text(const WaveSignal& signal, const std::string& value);

// Reads both files up to the first difference. Throws InputError when a file cannot be read or is no waveform.
[[nodiscard]] WaveComparison compare_waves(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace armature::cosim
