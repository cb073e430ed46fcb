// Any bytes as a scenario file: it is loaded, or refused with at least one problem that names the file.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "cosim/scenario/files/scenario_loader.hpp"
#include "tests/fuzz/fuzzed_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace armature::cosim;
  static const test::FuzzedFile file{"fuzzed/scenario.toml"};
  static const LoadOptions options = [] {
    LoadOptions result;
    result.search_path.add({ARMATURE_SOURCE_DIR "/scenarios"});
    return result;
  }();
  file.write(data, size);
  try {
    const Scenario scenario = load_scenario(file.path(), options);
    if (scenario.robot.axis_count == 0) std::abort();
  } catch (const InputError& error) {
    if (error.problems().empty()) std::abort();
    for (const Problem& problem : error.problems()) {
      if (problem.file.empty() || problem.message.empty()) std::abort();
    }
  }
  return 0;
}
