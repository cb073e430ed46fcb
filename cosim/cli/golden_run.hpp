// When the trace of a run is compared with the scenario's golden, and the folder of a run that leaves nothing behind.
#pragma once

#include <filesystem>
#include <string>

#include "cosim/cli/commands.hpp"

namespace armature::cosim {

// A folder of its own that disappears with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// Why the run is not the one that the golden is of: an option that changes what it does. Empty: it is that one. A
// --set of [expect] or of trace.every_ticks changes nothing that is compared.
[[nodiscard]] std::string why_not_comparable(const RunArguments& arguments);

}  // namespace armature::cosim
