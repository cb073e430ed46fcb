// The names of commands in messages and reports.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "controller/base/tag.hpp"
#include "cosim/programs/gcode_files.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

// A line of a program.
struct ProgramLine {
  std::string file;  // relative to the scenario file
  std::uint32_t line = 0;
};

class CommandNames {
 public:
  CommandNames() = default;  // of a scenario without a program
  explicit CommandNames(const Scenario& scenario);

  [[nodiscard]] bool has_program() const { return has_program_; }
  // `move[3]` and `stream[0]` of the scenario, `line 12 of part.ngc` of its program, `pendant[3]` of the teach pendant.
  [[nodiscard]] std::string of(Tag tag) const;
  // The line of a place as the interpreter of the program defines it. The names are those of the key `program`, else of
  // the program that the pendant sends. If the controller gets several programs, a line has no file, and the jobs
  // behind the first one are `job 2`, and so on.
  [[nodiscard]] ProgramLine line(std::uint32_t place) const;
  // `line 12 of part.ngc`
  [[nodiscard]] std::string line_text(std::uint32_t place) const;

 private:
  bool has_program_ = false;
  std::vector<std::string> files_;  // of a robot program: one for each job
  GcodeLines gcode_lines_;          // of a G-code program with several files
};

// The index of a command in [[move]] of the scenario; nothing if another source gave the command.
[[nodiscard]] std::optional<std::uint32_t> move_index(Tag tag);

}  // namespace armature::cosim
