// Creates the processor that runs the controller. Only make_processor.cpp knows all implementations of the core
// program.
#pragma once

#include <functional>
#include <memory>

#include "controller/host_memory/memory.hpp"
#include "cosim/cpu/core_program.hpp"
#include "cosim/cpu/cpu_spec.hpp"
#include "cosim/cpu/processor.hpp"

namespace armature::cosim {

// Both cores are at the start of their mains. `memory` is the one that host and controller share, with all that the
// controller starts with; it must outlive the processor. Throws std::runtime_error when the program of the controller
// cannot be loaded, and InputError as require_processor().
[[nodiscard]] std::unique_ptr<Processor> make_processor(host_memory::HostMemory& memory, const CpuSpec& spec);

// The program alone, for a core without a processor around it. `memory` and exceptions as above.
[[nodiscard]] std::unique_ptr<CoreProgram> make_core_program(host_memory::HostMemory& memory, const CpuSpec& spec);

// The simulator of ARM instructions is not a part of every program (armature-iss): its main provides it, before it
// makes a processor.
using MakeCoreProgram =
    std::function<std::unique_ptr<CoreProgram>(host_memory::HostMemory& memory, const CpuSpec& spec)>;
void provide_a9(MakeCoreProgram make);
[[nodiscard]] bool is_provided(CpuKind kind);
// Throws InputError for a processor that is not provided, and for `cpi` without one that executes instructions.
void require_processor(const CpuSpec& spec);

}  // namespace armature::cosim
