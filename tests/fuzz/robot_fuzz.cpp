// Any bytes as a robot file: it is loaded, or refused with at least one problem that names the file.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "cosim/scenario/files/robot_loader.hpp"
#include "tests/fuzz/fuzzed_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace armature::cosim;
  static const test::FuzzedFile file{"fuzzed.toml"};
  file.write(data, size);
  try {
    if (load_robot(file.path()).axis_count == 0) std::abort();
  } catch (const InputError& error) {
    if (error.problems().empty()) std::abort();
    for (const Problem& problem : error.problems()) {
      if (problem.file.empty() || problem.message.empty()) std::abort();
    }
  }
  return 0;
}
