// Any bytes as an STL file: it gives a mesh whose indices are within its corners, or it is refused with a message.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "cosim/mesh/stl_file.hpp"
#include "cosim/text/input_error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace armature::cosim;
  try {
    const TriangleMesh mesh = parse_stl({reinterpret_cast<const char*>(data), size}, "fuzzed.stl");
    if (mesh.triangles.empty()) std::abort();
    for (const auto& triangle : mesh.triangles) {
      if (std::ranges::max(triangle) >= mesh.corners.size()) std::abort();
    }
  } catch (const InputError& error) {
    if (error.problems().size() != 1 || error.problems()[0].message.empty()) std::abort();
  }
  return 0;
}
