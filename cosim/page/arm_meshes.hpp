// The shapes of the parts of an arm for the pages: what web/meshes.js reads.
//
//   {"base": mesh, "links": [mesh, ...], "problem": "..."}
//
// A mesh is null, or {"x", "y", "z": columns with a value for each corner [mm], "triangles": a column with three
// indices of corners for each triangle}; columns as in column_code.hpp. `problem` says why a part has no mesh.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "cosim/recording/recorded_input.hpp"

namespace armature::cosim {

using ReadMeshFile = std::function<RecordedInput(const std::string& file)>;

// `meshes`: the key `arm.meshes` of summary.json, which names the files; null: the robot has none, and the result is
// null.
[[nodiscard]] nlohmann::ordered_json arm_meshes(const nlohmann::ordered_json& meshes, const ReadMeshFile& read);

// Of the arm of a run, from the files that its summary names, if they are still the same.
[[nodiscard]] nlohmann::ordered_json recorded_meshes(const nlohmann::ordered_json& summary);

}  // namespace armature::cosim
