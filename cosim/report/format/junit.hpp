// JUnit XML of `armature check`, as CI servers read it.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace armature::cosim {

struct JunitCase {
  std::string name;  // of the scenario
  double wall_s = 0;
  std::string failure{};      // why a check failed; the first line is the message; empty when it passed
  std::string error{};        // why the run was not judged (bad input, internal error); empty otherwise
  std::string report{};       // page that shows the run; empty: none
  double simulated_s = 0;     // of the run
  std::string description{};  // of the scenario
  std::string picture{};      // of the run as SVG, for an index; empty: none
  std::string output{};       // shown with the case, such as the summary
  std::vector<std::pair<std::string, std::string>> properties{};  // name and value of each fact of the run
};

// The whole document; characters that XML does not allow are replaced.
[[nodiscard]] std::string junit_xml(const std::vector<JunitCase>& cases);

}  // namespace armature::cosim
