// Collects triangles into a mesh: rounds corners, and gives each place one index.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "cosim/mesh/triangle_mesh.hpp"

namespace armature::cosim {

class MeshBuilder {
 public:
  using Point = std::array<double, 3>;  // [mm], finite, at most 10^7

  // A triangle with two equal corners after rounding is left out.
  void add(const std::array<Point, 3>& corners) {
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t i = 0; i < triangle.size(); ++i) triangle.at(i) = index_of(corners.at(i));
    const auto [a, b, c] = triangle;
    if (a != b && b != c && c != a) mesh_.triangles.push_back(triangle);
  }

  [[nodiscard]] TriangleMesh take() { return std::move(mesh_); }

 private:
  using Corner = std::array<std::int32_t, 3>;
  struct Hash {
    std::size_t operator()(const Corner& corner) const noexcept {
      std::uint64_t hash = 0;
      for (const std::int32_t value : corner) {
        hash = (hash ^ static_cast<std::uint32_t>(value)) * 0x9e3779b97f4a7c15U;
        hash ^= hash >> 32U;
      }
      return hash;
    }
  };

  [[nodiscard]] std::uint32_t index_of(const Point& point) {
    static const double kScale = std::pow(10.0, TriangleMesh::kDigits);
    Corner corner{};
    for (std::size_t i = 0; i < corner.size(); ++i) {
      corner.at(i) = static_cast<std::int32_t>(std::lround(point.at(i) * kScale));
    }
    const auto [place, is_new] = indices_.try_emplace(corner, static_cast<std::uint32_t>(mesh_.corners.size()));
    if (is_new) mesh_.corners.push_back(corner);
    return place->second;
  }

  TriangleMesh mesh_;
  std::unordered_map<Corner, std::uint32_t, Hash> indices_;
};

}  // namespace armature::cosim
