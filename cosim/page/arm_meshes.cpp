#include "cosim/page/arm_meshes.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "cosim/mesh/stl_file.hpp"
#include "cosim/page/column_json.hpp"
#include "cosim/text/json.hpp"

namespace armature::cosim {
namespace {

Json mesh_json(const TriangleMesh& mesh) {
  Json json = Json::object();
  constexpr std::array<const char*, 3> kAxisNames{"x", "y", "z"};
  for (std::size_t axis = 0; axis < kAxisNames.size(); ++axis) {
    std::vector<std::int64_t> values;
    values.reserve(mesh.corners.size());
    for (const auto& corner : mesh.corners) values.push_back(corner.at(axis));
    json[kAxisNames.at(axis)] = column_json(kAxisNames.at(axis), TriangleMesh::kDigits, values);
  }
  std::vector<std::int64_t> indices;
  indices.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) indices.insert(indices.end(), triangle.begin(), triangle.end());
  json["triangles"] = column_json("triangles", 0, indices);
  return json;
}

}  // namespace

Json arm_meshes(const Json& meshes, const ReadMeshFile& read) {
  if (meshes.is_null()) return nullptr;
  Json json = {{"base", nullptr}, {"links", Json::array()}, {"problem", ""}};
  const auto mesh_of = [&](const std::string& file) -> Json {
    if (file.empty()) return nullptr;
    const RecordedInput input = read(file);
    if (input.problem.empty()) return mesh_json(parse_stl(input.content, file));
    json["problem"] = std::filesystem::path{file}.filename().string() + ": " + input.problem;
    return nullptr;
  };
  json["base"] = mesh_of(meshes.value("base", ""));
  for (const Json& link : meshes["links"]) {
    Json mesh = mesh_of(link.get<std::string>());  // first: it may change `json`
    json["links"].push_back(std::move(mesh));
  }
  return json;
}

Json recorded_meshes(const Json& summary) {
  if (!summary.contains("arm") || !summary.contains("inputs")) return nullptr;
  return arm_meshes(summary["arm"].value("meshes", Json(nullptr)),
                    [&](const std::string& file) { return recorded_input(summary, file, kMaxMeshBytes); });
}

}  // namespace armature::cosim
