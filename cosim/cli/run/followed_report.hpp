// The report of a run that another process is still writing.
#pragma once

#include <filesystem>

namespace armature::cosim {

// Writes the page, and the script beside it by which an open page reloads itself, whenever the run has written more
// rows; the last time when the run is over. Returns false when interrupted. The caller has called catch_interrupts().
// Throws InputError as write_report(), but waits for the first row while the run continues.
[[nodiscard]] bool follow_report(const std::filesystem::path& folder, const std::filesystem::path& page);

}  // namespace armature::cosim
