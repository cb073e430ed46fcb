// The report page of a run, as the commands that write one need it.
#pragma once

#include <filesystem>
#include <optional>

namespace armature::cosim {

inline constexpr const char* kReportFile = "report.html";

// Writes the page of the results in `folder` to `page`. It also shows the trace `other`; by default the golden of the
// scenario, if the run was compared with it. Throws InputError when the folder has no results.
void write_report(const std::filesystem::path& folder, const std::filesystem::path& page,
                  const std::optional<std::filesystem::path>& other = {});

}  // namespace armature::cosim
