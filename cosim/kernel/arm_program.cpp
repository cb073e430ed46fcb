#include "cosim/kernel/arm_program.hpp"

#include <span>

#include "controller/language/gcode/run/program_runner.hpp"
#include "controller/language/job/execute/machine.hpp"
#include "controller/language/job/loader/loader.hpp"
#include "controller/language/job/memory/program_memory.hpp"
#include "cosim/programs/gcode_files.hpp"
#include "cosim/programs/program_name.hpp"
#include "cosim/scenario/to_controller.hpp"

namespace armature::cosim {
namespace {

// The loader of the scenario has reported all errors.
class NoDiagnostics final : public Diagnostics {
 public:
  void report(const Diagnostic&) noexcept override {}
};

}  // namespace

struct ArmProgram::Gcode {
  Gcode(const gcode::MotionSetup& of_cell, std::span<const ProgramFile> files) : setup{of_cell}, text{files} {
    runner.load(text.text());
  }

  gcode::MotionSetup setup;
  JoinedGcode text;
  gcode::ProgramRunner runner{setup};
};

struct ArmProgram::Jobs {
  explicit Jobs(const job::MachineSetup& of_cell) : setup{of_cell} {}

  job::MachineSetup setup;
  job::ProgramMemory memory{};
  job::Machine machine{memory, setup};
};

ArmProgram::ArmProgram(const Scenario& scenario) : robot_{to_robot_model(scenario.robot)}, arm_{robot_} {
  if (program_language(*scenario.program) == ProgramLanguage::kGcode) {
    load_gcode(scenario);
  } else {
    load_jobs(scenario);
  }
}

ArmProgram::~ArmProgram() = default;

void ArmProgram::load_gcode(const Scenario& scenario) {
  gcode_ = std::make_unique<Gcode>(to_gcode_setup(scenario, robot_, arm_), scenario.program_files);
  interpreter_ = &gcode_->runner;
}

void ArmProgram::load_jobs(const Scenario& scenario) {
  jobs_ = std::make_unique<Jobs>(to_job_setup(scenario, robot_, arm_));
  NoDiagnostics none;
  const auto loader = std::make_unique<job::Loader>(jobs_->memory, none);
  for (const ProgramFile& file : scenario.program_files) static_cast<void>(loader->load(file.name, file.text));
  static_cast<void>(loader->link());
  interpreter_ = &jobs_->machine;
}

}  // namespace armature::cosim
