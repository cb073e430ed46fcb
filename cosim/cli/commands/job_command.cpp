#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "controller/language/job/execute/alarm_check.hpp"
#include "controller/language/job/loader/loader.hpp"
#include "controller/language/job/loader/printer.hpp"
#include "controller/language/job/memory/instruction.hpp"
#include "controller/language/job/memory/program_memory.hpp"
#include "controller/language/job/memory/words.hpp"
#include "cosim/cli/command/command.hpp"
#include "cosim/cli/options/action_argument.hpp"
#include "cosim/cli/options/kinematics_io.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kJobDetails = R"(Examples:
  armature job instructions
  printf '/JOB\n//NAME WAVE\n//POS\n//INST\nNOP\nDOUT OT#(1) ON\nEND\n' | armature job -
  printf '/JOB\n//NAME WAVE\n//POS\n//INST\nNOP\nDOUT OT#(1) ON\nEND\n' | armature job list -
  printf '/JOB\n//NAME WAVE\n//POS\n//INST\nNOP\nDOUT OT#(1)\nEND\n' | armature job check - 2>&1   # exits with 2: no state

check         loads all files as one program and reports everything that is wrong, as file:line:column; it warns of
              instructions that are an alarm when they are executed
print         writes a program from its encoded form; equal to the file except for line ends, which become CR LF
list          writes the encoded instructions: where each continues, and its operands
instructions  writes the table of all instructions
The language is a subset that is compatible with INFORM job files (.jbi). A call of a job needs the file of that job, too.
Exit code: 0 ok, 2 bad input.)";

constexpr const char* kCheckJobs = "check";
constexpr const char* kPrintJobs = "print";
constexpr const char* kListJobs = "list";
constexpr const char* kInstructions = "instructions";

// Prints each diagnostic as a line on standard error.
class PrintedDiagnostics final : public Diagnostics {
 public:
  void report(const Diagnostic& diagnostic) noexcept override {
    const bool error = diagnostic.severity == Diagnostic::Severity::kError;
    std::cerr << fmt::format("{}:{}:{}: {}{}\n", printable(diagnostic.file, kShowAll), diagnostic.line,
                             diagnostic.column, error ? "" : "warning: ", printable(diagnostic.text.view()));
  }
};

class StreamSink final : public TextSink {
 public:
  void write(std::string_view text) noexcept override { std::cout.write(text.data(), std::ssize(text)); }
};

void print_instructions() {
  std::cout << fmt::format("{:<10} {:<8} {:<22} {}\n", "name", "operands", "tags", "what it does");
  for (std::size_t i = 0; i < job::instruction_count(); ++i) {
    const job::Instruction& instruction = job::instruction_at(i);
    if (instruction.name.empty()) continue;
    std::string tags;
    for (std::size_t t = 0; t < job::kTagNames.size(); ++t) {
      if ((instruction.tags >> t & 1U) != 0) tags += fmt::format("{}{}=", tags.empty() ? "" : " ", job::kTagNames[t]);
    }
    std::cout << fmt::format("{:<10} {:<8} {:<22} {}\n", instruction.name, instruction.pattern, tags, instruction.text);
  }
}

int run_job(const ActionArguments& given) {
  if (given.action == kInstructions) {
    print_instructions();
    return kExitOk;
  }
  const auto memory = std::make_unique<job::ProgramMemory>();
  PrintedDiagnostics diagnostics;
  const auto loader = std::make_unique<job::Loader>(*memory, diagnostics);
  bool good = true;
  for (const std::string& file : given.files) {
    const TextInput input = read_input(file);
    good = loader->load(input.name, input.text) && good;
  }
  if (given.action == kCheckJobs) {
    good = loader->link() && good;
    if (good) {
      job::warn_of_alarms(*memory, {}, diagnostics);
      std::cout << fmt::format("{} jobs, {} instructions, {} positions\n", memory->job_count, memory->record_count,
                               memory->position_count);
    }
  }
  if (!good) return kExitBadInput;
  StreamSink out;
  for (std::size_t i = 0; i < memory->job_count; ++i) {
    if (given.action == kPrintJobs) print_job(*memory, memory->jobs[i], out);
    if (given.action == kListJobs) list_job(*memory, memory->jobs[i], out);
  }
  return kExitOk;
}

CommandAction declare_job(CLI::App& app) {
  const auto options = std::make_shared<ActionArguments>(
      ActionArguments{.actions = {kCheckJobs, kPrintJobs, kListJobs, kInstructions}, .fileless = {kInstructions}});
  add_action(app, *options, "Job files, '-' for standard input");
  app.callback([options] { check_action(*options); });
  return [options](const CommonOptions&) { return run_job(*options); };
}

}  // namespace

Subcommand job_command() {
  return {.name = "job",
          .order = 55,
          .summary = "Check, print and list robot programs (.jbi)",
          .details = kJobDetails,
          .declare = declare_job};
}

}  // namespace armature::cosim
