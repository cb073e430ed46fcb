// The report page of a run, as the commands that write one need it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cosim/page/report_page.hpp"
#include "cosim/report/judge/run_summary.hpp"

namespace armature::cosim {

inline constexpr const char* kReportFile = "report.html";

// A page shows rows of the trace. A run that ends before its first tick has none.
[[nodiscard]] inline bool can_be_shown(const RunSummary& summary) {
  return summary.facts.ticks > 0;
}
inline constexpr const char* kNoReport = "no report      the run ended before its first tick\n";

struct ReportRequest {
  // A trace to show, too. None: the golden of the scenario, if the run was compared with it.
  std::optional<std::filesystem::path> other{};
  PageOptions page{};
  bool so_far = false;  // no warning about a run that is not complete
};

// Writes the page of the results in `folder` to `page`. Returns the digest of its content. Throws InputError when the
// folder has no results.
std::string write_report(const std::filesystem::path& folder, const std::filesystem::path& page,
                         const ReportRequest& request = {});
// The same for a page that reloads itself, and writes the script beside it that tells an open page to do so.
std::string write_reloading_report(const std::filesystem::path& folder, const std::filesystem::path& page,
                                   ReportRequest request = {});

}  // namespace armature::cosim
