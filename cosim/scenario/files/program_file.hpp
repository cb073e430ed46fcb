// The program of a scenario: its files are read, and everything that is wrong with their texts is reported.
#pragma once

#include <vector>

#include "cosim/scenario/scenario.hpp"
#include "cosim/scenario/toml/table_reader.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {

// Reads the file that the key `program` names, for a robot program also those of the jobs that it calls, and adds them
// to the sources of the scenario. A file that is missing is a problem of `root`. The others are added to `all`:
// all errors of a file, each with line and column. Whether the arm can follow the program shows only in the run.
void load_program(Scenario& scenario, TableReader& root, std::vector<Problem>& all);

}  // namespace armature::cosim
