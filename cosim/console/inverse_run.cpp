#include "cosim/console/inverse_run.hpp"

#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "controller/host_memory/boot_memory.hpp"
#include "controller/host_memory/host_side.hpp"
#include "cosim/bus/bus_spec.hpp"
#include "cosim/console/console_bus.hpp"
#include "cosim/cpu/make_processor.hpp"
#include "cosim/engine/make_soc.hpp"

namespace armature::cosim {

InverseRun run_inverse(const RobotModel& robot, const InverseTask& task, const CpuSpec& cpu) {
  constexpr int kSolvingCore = 1;
  host_memory::BootMemory memory{robot, {.inverse = task}};
  const std::unique_ptr<CoreProgram> program = make_core_program(memory.memory(), cpu);
  const std::unique_ptr<Soc> soc = make_soc(Variant::kCounts, Engine::kModel, BusSpec{}, 1);
  ConsoleBus bus{*soc, {.baud = task.baud}, kLongestInverseRun, [&] { return program->instructions(kSolvingCore); }};
  program->main(kSolvingCore, bus);
  if (const auto* problem = host_memory::HostSide{memory.memory()}.boot_problem()) {
    throw std::runtime_error{fmt::format("the controller does not start: problem {}", problem->problem)};
  }
  if (!bus.receive_until(InverseTask::kEnd)) {
    throw std::runtime_error{fmt::format("the text of the core does not end; it has {} characters", bus.text().size())};
  }
  if (bus.failures() > 0) {
    throw std::runtime_error{fmt::format("{} errors of the serial line or of the bus", bus.failures())};
  }
  return {.text = bus.text().substr(0, bus.text().size() - InverseTask::kEnd.size()),
          .instructions = bus.inverse().instructions,
          .clocks = bus.inverse().clocks,
          .end = soc->now()};
}

}  // namespace armature::cosim
