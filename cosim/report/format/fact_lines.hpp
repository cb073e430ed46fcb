// Facts on the screen and in JUnit, as the list of facts has them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cosim/report/judge/run_summary.hpp"

namespace armature::cosim {

// Lines of the summary, each ends with '\n': facts with one number, a table with a column for each axis, facts of the
// tool.
[[nodiscard]] std::string number_lines(const RunSummary& summary);
[[nodiscard]] std::string axis_lines(const RunSummary& summary);
[[nodiscard]] std::string tool_lines(const RunSummary& summary);

// Name and value of every fact that the run has.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> fact_properties(const RunSummary& summary);

}  // namespace armature::cosim
