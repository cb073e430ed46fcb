#include "cosim/cli/golden_run.hpp"

#include <cerrno>
#include <cstdlib>
#include <system_error>

namespace armature::cosim {

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "armature-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::system_error(errno, std::generic_category(), name);
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string why_not_comparable(const RunArguments& arguments) {
  for (const std::string& assignment : arguments.set) {
    if (assignment.starts_with("expect.") || assignment.starts_with("trace.every_ticks=")) continue;
    return "the run has --set " + assignment;
  }
  if (arguments.fabric) return "the run has --fabric " + *arguments.fabric;
  if (arguments.serial) return "the run has --serial " + *arguments.serial;
  return {};
}

}  // namespace armature::cosim
