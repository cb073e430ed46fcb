// The program texts that a run executed, read again from their files.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace armature::cosim {

struct RecordedProgram {
  std::string name;       // as events of the summary name it, such as part.ngc
  std::string text{};     // empty: see `problem`
  std::string problem{};  // why there is no text, in words; empty: there is one
};

// Each file of which the program executed a line, in the order of their first lines. A file that has another digest
// than in the summary is not shown: it is not what ran.
[[nodiscard]] std::vector<RecordedProgram> recorded_programs(const nlohmann::ordered_json& summary);

}  // namespace armature::cosim
