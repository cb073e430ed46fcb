#include "cosim/cli/run/followed_report.hpp"

#include <chrono>
#include <thread>

#include "cosim/cli/run/file_changes.hpp"
#include "cosim/cli/run/interrupt.hpp"
#include "cosim/cli/run/report_file.hpp"
#include "cosim/run/run_folder.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

// Pages are slower to load than to write.
constexpr std::chrono::seconds kBetweenPages{1};
// The newest moment: a page shows its last one instead of a later one.
constexpr double kNewest_s = 1e9;

}  // namespace

bool follow_report(const fs::path& folder, const fs::path& page) {
  const PageOptions newest{.shown = ShownPart{.from_s = 0, .to_s = kNewest_s, .time_s = kNewest_s}};
  FileChanges trace;
  trace.add(folder / kTraceFile);
  for (bool first = true; !interrupted(); first = false) {
    if (!is_being_written(folder)) {
      write_reloading_report(folder, page);
      return true;
    }
    if (first || trace.changed()) {
      trace.restart();
      try {
        write_reloading_report(folder, page, {.page = newest, .so_far = true});
      } catch (const InputError&) {
        // No row yet, or the run has just ended and removed its mark. The last page tells what is wrong.
      }
    }
    for (std::chrono::milliseconds slept{0}; slept < kBetweenPages && !interrupted(); slept += FileChanges::kPause) {
      std::this_thread::sleep_for(FileChanges::kPause);
    }
  }
  return false;
}

}  // namespace armature::cosim
