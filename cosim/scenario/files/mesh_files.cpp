#include "cosim/scenario/files/mesh_files.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

#include "cosim/mesh/stl_file.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

void load_mesh(TableReader& table, const fs::path& folder, const char* key, std::string& name, RobotSpec& robot,
               std::vector<Problem>& all) {
  if (name.empty()) return;
  const fs::path file = (folder / name).lexically_normal();
  name = file.string();
  if (std::ranges::find(robot.mesh_files, name, &InputFile::file) != robot.mesh_files.end()) return;
  if (!is_file(file)) {
    table.problem(key, "no such file: " + printable(name));
    return;
  }
  try {
    const std::string content = read_binary_file(file, kMaxMeshBytes);
    static_cast<void>(parse_stl(content, name));  // so that a run does not end without its picture
    robot.mesh_files.push_back(input_file(name, content));
  } catch (const InputError& error) {
    all.insert(all.end(), error.problems().begin(), error.problems().end());
  }
}

}  // namespace

void load_meshes(TableReader& table, const fs::path& folder, RobotSpec& robot, std::vector<Problem>& all) {
  MeshesSpec& meshes = robot.meshes;
  if (!robot.kinematics) {
    table.problem(meshes.base.empty() ? "links" : "base", "needs [kinematics], which moves the parts");
    return;
  }
  if (!meshes.links.empty() && meshes.links.size() != robot.axis_count) {
    table.problem("links", "expected " + std::to_string(robot.axis_count) + " names, one for each joint, found " +
                               std::to_string(meshes.links.size()));
    return;
  }
  load_mesh(table, folder, "base", meshes.base, robot, all);
  for (std::string& link : meshes.links) load_mesh(table, folder, "links", link, robot, all);
}

}  // namespace armature::cosim
