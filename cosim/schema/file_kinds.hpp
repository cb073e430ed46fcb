// The kinds of files that users write and that have a schema.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "cosim/scenario/keys/key_info.hpp"
#include "cosim/scenario/tables/tables.hpp"

namespace armature::cosim {

struct FileKind {
  std::string_view name;    // as an argument of `armature schema`
  std::string_view title;   // of the schema
  std::string_view schema;  // its file, in a folder of scenarios
  TableInfo (*keys)();
};

inline constexpr std::array<FileKind, 2> kFileKinds{
    {{"scenario", "A scenario of armature", "scenario.schema.json", scenario_file},
     {"robot", "A robot of armature", "robots/robot.schema.json", robot_file}}};
inline constexpr const FileKind& kScenarioFiles = kFileKinds[0];

// The text of the schema file, the same wherever it is written.
[[nodiscard]] std::string schema_text(const FileKind& kind);

}  // namespace armature::cosim
