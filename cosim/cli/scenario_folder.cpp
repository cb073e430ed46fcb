#include "cosim/cli/scenario_folder.hpp"

#include <optional>
#include <system_error>

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> search_upwards(fs::path folder) {
  for (;; folder = folder.parent_path()) {
    std::error_code ignored;
    if (fs::is_directory(folder / "scenarios" / "robots", ignored)) return folder / "scenarios";
    if (folder == folder.parent_path()) return std::nullopt;
  }
}

}  // namespace

fs::path scenario_folder() {
  std::error_code ignored;
  if (const auto found = search_upwards(fs::current_path(ignored))) return fs::proximate(*found);
  if (const auto found = search_upwards(fs::read_symlink("/proc/self/exe", ignored).parent_path())) return *found;
  return "scenarios";
}

}  // namespace armature::cosim
