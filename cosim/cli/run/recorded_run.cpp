#include "cosim/cli/run/recorded_run.hpp"

#include <fmt/format.h>

#include <iostream>
#include <system_error>

#include "cosim/run/run_folder.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

// A run that has not written its summary left the one that was made before the run.
RunRecord record_of(const std::filesystem::path& folder, bool unfinished) {
  std::error_code ignored;
  if (unfinished && std::filesystem::exists(folder / kTraceFile, ignored) &&
      !std::filesystem::exists(folder / kSummaryFile, ignored)) {
    return read_run_record(folder, kTraceFile, unfinished_summary(folder), folder);
  }
  return read_run_record(folder, kTraceFile, kSummaryFile);
}

}  // namespace

RunRecord recorded_run(const std::filesystem::path& folder) {
  const auto why = why_unfinished(folder);
  if (why) std::cerr << fmt::format("{}: unfinished: {}\n", printable(folder.string(), kShowAll), *why);
  return record_of(folder, why.has_value());
}

RunRecord run_record_so_far(const std::filesystem::path& folder) {
  return record_of(folder, why_unfinished(folder).has_value());
}

void reads_results(OutputFiles& files, const std::filesystem::path& folder) {
  require_run_folder(folder);
  files.reads(folder / kTraceFile);
  files.reads(folder / kSummaryFile);
}

}  // namespace armature::cosim
