#include "cosim/cli/waves/wave_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "cosim/text/input_error.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/shell_text.hpp"
#include "cosim/text/text_file.hpp"
#include "cosim/waves/gtkwave_view.hpp"
#include "cosim/waves/wave_input.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> waves_in(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator{folder, ignored}) {
    if (is_wave_name(entry.path()) && is_file(entry.path())) found.push_back(entry.path());
  }
  std::ranges::sort(found);
  return found;
}

std::string shown(const fs::path& path) {
  return printable(path.string(), kShowAll);
}

std::string gtkwave_command(const std::string& wave, const fs::path& view) {
  return fmt::format("gtkwave {} {}", shell_word(wave), shell_word(view.string()));
}

}  // namespace

WavePairs wave_pairs(const fs::path& folder_a, const fs::path& folder_b) {
  const std::vector<fs::path> of_a = waves_in(folder_a), of_b = waves_in(folder_b);
  WavePairs found;
  for (const fs::path& a : of_a) {
    for (const fs::path& b : of_b) {
      if (a.filename() == b.filename()) found.pairs.push_back({a, b});
    }
  }
  if (found.pairs.empty() && of_a.size() == 1 && of_b.size() == 1) found.pairs.push_back({of_a.front(), of_b.front()});
  if (!found.pairs.empty() || (of_a.empty() && of_b.empty())) return found;
  const bool one_has_none = of_a.empty() || of_b.empty();
  found.why_none =
      one_has_none ? fmt::format("no waveform in {}\n", shown(of_a.empty() ? folder_a : folder_b))
                   : fmt::format("waveforms are not compared: those in {} and {} have other names; name two files\n",
                                 shown(folder_a), shown(folder_b));
  return found;
}

WavePair view_files(const fs::path& folder) {
  return {folder / "a.gtkw", folder / "b.gtkw"};
}

std::string write_wave_views(const WaveComparison& comparison, const fs::path& folder) {
  const WavePair views = view_files(folder);
  replace_text_file(views.a, gtkwave_view(comparison.first.value(), comparison.unit_a_ps));
  replace_text_file(views.b, gtkwave_view(comparison.first.value(), comparison.unit_b_ps));
  return fmt::format("  {}\n  {}\n", gtkwave_command(comparison.a, views.a), gtkwave_command(comparison.b, views.b));
}

void open_wave_views(const WaveComparison& comparison, const fs::path& folder) {
  if (std::system("command -v gtkwave >/dev/null 2>&1") != 0) {
    throw InputError{"--open", "needs the program gtkwave (Debian package gtkwave), which is not installed"};
  }
  const WavePair views = view_files(folder);
  for (const std::string& command : {gtkwave_command(comparison.a, views.a), gtkwave_command(comparison.b, views.b)}) {
    if (std::system((command + " >/dev/null 2>&1 </dev/null &").c_str()) != 0) {
      throw InputError{"--open", "cannot start gtkwave"};
    }
  }
}

}  // namespace armature::cosim
