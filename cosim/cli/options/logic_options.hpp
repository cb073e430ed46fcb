// --variant and --engine, of the commands that run the programmable logic.
#pragma once

#include <CLI/CLI.hpp>
#include <vector>

#include "cosim/logic/logic_spec.hpp"

namespace armature::cosim {

// Adds the two options to `command`. `chosen` must outlive the parsing. The option --fabric, which stood for both
// before, is refused with the option that replaces it.
void add_logic_options(CLI::App& command, LogicChoice& chosen);

// Adds --engine alone, which takes a further word: `both` runs the RTL, then the model. `chosen`: the engines, one
// after the other; empty: that of the scenario.
void add_engines_option(CLI::App& command, std::vector<Engine>& chosen);

}  // namespace armature::cosim
