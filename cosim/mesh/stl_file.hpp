// Reads STL, the file format for triangles that every CAD program writes: as text or as binary data.
//
// Text:    solid NAME / facet normal x y z / outer loop / vertex x y z (three times) / endloop / endfacet / ... /
// endsolid Binary:  80 bytes of any content, the number of triangles (32 bits), and 50 bytes for each: normal and three
// corners
//          (32-bit floats) and 16 unused bits, all little-endian
//
// A file has no unit: its numbers are mm here. Normals are not used, because the order of the corners gives them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "cosim/mesh/triangle_mesh.hpp"

namespace armature::cosim {

inline constexpr std::size_t kMaxMeshTriangles = 200'000;  // of a file: a page stays below some MB
inline constexpr std::size_t kMaxMeshBytes = std::size_t{64} << 20U;
inline constexpr double kMaxMeshMm = 100'000;  // of a coordinate

// Triangles without an area at 0.01 mm are left out. Throws InputError with `name` and the line, or the number of the
// triangle of a binary file: no STL, a missing word or number, no triangle, too many of them.
[[nodiscard]] TriangleMesh parse_stl(std::string_view content, const std::string& name);

// The same from a file.
[[nodiscard]] TriangleMesh read_stl(const std::filesystem::path& file);

}  // namespace armature::cosim
