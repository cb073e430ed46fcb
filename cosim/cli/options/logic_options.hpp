// --variant and --engine, of every command that runs the programmable logic.
#pragma once

#include <CLI/CLI.hpp>

#include "cosim/logic/logic_spec.hpp"

namespace armature::cosim {

// Adds the two options to `command`. `chosen` must outlive the parsing. The option --fabric, which stood for both
// before, is refused with the option that replaces it.
void add_logic_options(CLI::App& command, LogicChoice& chosen);

}  // namespace armature::cosim
