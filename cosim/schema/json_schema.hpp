// JSON Schemas (draft 7) of scenario and robot files, for editors that check TOML and complete keys.
#pragma once

#include <string>

#include "cosim/scenario/keys/key_info.hpp"

namespace armature::cosim {

// A schema says what a table says by itself. What depends on the robot, on other tables or on sums of keys is the
// loader's business. `id`: the URI by which other schemas know this one, wherever its file is.
[[nodiscard]] std::string json_schema(const TableInfo& file, const std::string& id, const std::string& title);

}  // namespace armature::cosim
