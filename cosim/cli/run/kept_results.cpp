#include "cosim/cli/run/kept_results.hpp"

#include <array>
#include <map>

#include "cosim/report/format/json/summary_json.hpp"
#include "cosim/run/engine_waves.hpp"
#include "cosim/run/run_folder.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

// The files that the run has written. The summary is added to them.
constexpr std::array kRunFiles{kTraceFile, kLoadFile, kLogFile, kSerialFile};

}  // namespace

std::vector<fs::path> result_folders(const std::vector<Scenario>& scenarios, const fs::path& out) {
  std::vector<fs::path> folders;
  std::map<std::string, int> taken;
  for (const Scenario& scenario : scenarios) {
    std::string name = scenario.name;
    for (int n = ++taken[scenario.name]; n > 1 && taken[name] > 0; ++n) name = scenario.name + "-" + std::to_string(n);
    if (name != scenario.name) ++taken[name];
    folders.push_back(out / name);
  }
  return folders;
}

void remove_results(const fs::path& folder) {
  if (!fs::is_directory(folder)) return;
  for (const char* name : kResultFiles) fs::remove(folder / name);
  for (const char* name : kEngineWaveFiles) fs::remove(folder / name);
  if (fs::is_empty(folder)) fs::remove(folder);
}

void keep_results(const fs::path& run, const RunSummary& summary, const fs::path& folder) {
  fs::create_directories(folder);
  for (const char* name : kRunFiles) {
    if (fs::exists(run / name)) fs::copy_file(run / name, folder / name, fs::copy_options::overwrite_existing);
  }
  replace_text_file(folder / kSummaryFile, summary_json(summary));
}

}  // namespace armature::cosim
