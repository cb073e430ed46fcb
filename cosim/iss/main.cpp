// armature-iss: armature with a simulator of ARM instructions, for --cpu a9.

#include <memory>

#include "cosim/cli/main/cli.hpp"
#include "cosim/cpu/make_processor.hpp"
#include "cosim/iss/arm_program.hpp"
#include "cosim/iss/debug/debug_command.hpp"
#include "cosim/iss/firmware.hpp"

int main(int argc, char** argv) {
  using namespace armature;
  cosim::provide_a9(
      [](host_memory::HostMemory& memory, const cosim::CpuSpec& spec) -> std::unique_ptr<cosim::CoreProgram> {
        return std::make_unique<cosim::iss::ArmProgram>(cosim::iss::firmware(), memory, spec.cpi);
      });
  return cosim::cli_main(argc, argv, {cosim::iss::debug_command()});
}
