// The waveforms of two runs, as `compare` compares and shows them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cosim/waves/wave_compare.hpp"

namespace armature::cosim {

struct WavePair {
  std::filesystem::path a, b;
};

// The waveforms of two folders of results that belong together: those of one name, or the only one of each folder. If
// there are waveforms and none belong together, `why_none` says so in one line, which ends with '\n'.
struct WavePairs {
  std::vector<WavePair> pairs{};
  std::string why_none{};
};
[[nodiscard]] WavePairs wave_pairs(const std::filesystem::path& folder_a, const std::filesystem::path& folder_b);

// The files that write_wave_views() writes.
[[nodiscard]] WavePair view_files(const std::filesystem::path& folder);

// Writes a view of the first difference for each of the two files. Returns the commands that open them, each in a line
// that begins with two blanks. Throws InputError when a file cannot be written.
[[nodiscard]] std::string write_wave_views(const WaveComparison& comparison, const std::filesystem::path& folder);

// Starts GTKWave with both views and does not wait for it. Throws InputError when it is not installed.
void open_wave_views(const WaveComparison& comparison, const std::filesystem::path& folder);

}  // namespace armature::cosim
