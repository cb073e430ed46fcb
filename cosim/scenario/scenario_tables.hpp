// The tables of a scenario file, each with its keys and rules.
#pragma once

#include "cosim/scenario/scenario.hpp"
#include "cosim/scenario/table_reader.hpp"

namespace armature::cosim {

// Reads everything that stands in the scenario file itself: all of `scenario` but its name, places and robot.
void read_scenario(TableReader& root, Scenario& scenario);

// [expect] (expect_table.cpp).
void read_expect(TableReader& table, ExpectSpec& expect);

}  // namespace armature::cosim
