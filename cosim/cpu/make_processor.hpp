// Creates the processor that runs the controller. Only make_processor.cpp knows all implementations.
#pragma once

#include <memory>

#include "controller/host_memory/memory.hpp"
#include "cosim/cpu/cpu_spec.hpp"
#include "cosim/cpu/processor.hpp"

namespace armature::cosim {

// Both cores are at the start of their mains. `memory` is the one that host and controller share, with all that the
// controller starts with; it must outlive the processor.
[[nodiscard]] std::unique_ptr<Processor> make_processor(host_memory::HostMemory& memory, const CpuSpec& spec);

}  // namespace armature::cosim
