#include "cosim/cpu/make_processor.hpp"

#include "cosim/cpu/core_processor.hpp"
#include "cosim/cpu/host_program.hpp"

namespace armature::cosim {

std::unique_ptr<Processor> make_processor(host_memory::HostMemory& memory, const CpuSpec& spec) {
  return std::make_unique<CoreProcessor>(std::make_unique<HostProgram>(memory), spec);
}

}  // namespace armature::cosim
