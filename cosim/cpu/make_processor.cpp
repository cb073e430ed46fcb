#include "cosim/cpu/make_processor.hpp"

#include <memory>
#include <utility>

#include "cosim/cpu/core_processor.hpp"
#include "cosim/cpu/host_program.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {
namespace {

MakeCoreProgram a9_program;

}  // namespace

void provide_a9(MakeCoreProgram make) {
  a9_program = std::move(make);
}

bool is_provided(CpuKind kind) {
  return kind == CpuKind::kHost || a9_program;
}

void require_processor(const CpuSpec& spec) {
  if (spec.cpi && spec.processor == CpuKind::kHost) {
    throw InputError{"[cpu] cpi", "expected it with --cpu a9 or [cpu] processor = \"a9\", which execute instructions"};
  }
  if (is_provided(spec.processor)) return;
  throw InputError{"--cpu a9 or [cpu] processor = \"a9\"",
                   "this program executes no ARM instructions; expected host, or the program armature-iss (tools/iss)"};
}

std::unique_ptr<CoreProgram> make_core_program(host_memory::HostMemory& memory, const CpuSpec& spec) {
  require_processor(spec);
  if (spec.processor == CpuKind::kHost) return std::make_unique<HostProgram>(memory);
  return a9_program(memory, spec);
}

std::unique_ptr<Processor> make_processor(host_memory::HostMemory& memory, const CpuSpec& spec) {
  return std::make_unique<CoreProcessor>(make_core_program(memory, spec), spec.cpi ? without_costs(spec) : spec);
}

}  // namespace armature::cosim
