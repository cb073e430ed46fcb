#include "cosim/cli/run/recorded_run.hpp"

#include <fmt/format.h>

#include <iostream>
#include <system_error>

#include "cosim/run/run_folder.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {

RunRecord recorded_run(const std::filesystem::path& folder) {
  if (const auto why = why_unfinished(folder)) {
    std::cerr << fmt::format("{}: unfinished: {}\n", printable(folder.string(), kShowAll), *why);
  }
  return run_record_so_far(folder);
}

RunRecord run_record_so_far(const std::filesystem::path& folder) {
  std::error_code ignored;
  if (why_unfinished(folder) && std::filesystem::exists(folder / kTraceFile, ignored) &&
      !std::filesystem::exists(folder / kSummaryFile, ignored)) {
    return read_run_record(folder, kTraceFile, unfinished_summary(folder), folder);
  }
  return read_run_record(folder, kTraceFile, kSummaryFile);
}

void reads_results(OutputFiles& files, const std::filesystem::path& folder) {
  require_run_folder(folder);
  files.reads(folder / kTraceFile);
  files.reads(folder / kSummaryFile);
}

}  // namespace armature::cosim
