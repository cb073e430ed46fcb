#include "cosim/cpu/make_processor.hpp"

#include "cosim/cpu/fiber_processor.hpp"

namespace armature::cosim {

std::unique_ptr<Processor> make_processor(host_memory::HostMemory& memory, const CpuSpec& spec) {
  return std::make_unique<FiberProcessor>(memory, spec);
}

}  // namespace armature::cosim
