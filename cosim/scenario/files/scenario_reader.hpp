// A parsed scenario file into a Scenario. tables/ has the keys.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "cosim/scenario/keys/key_context.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/scenario/toml/table_reader.hpp"

namespace armature::cosim {

// The keys of the file itself, among them the one that names the robot. Returns those that are missing or wrong.
std::vector<std::string_view> read_scenario_keys(TableReader& root, Scenario& scenario);

// The tables of the file, after its keys, of which `bad` were missing or wrong. `chosen` replaces the keys `variant`
// and `engine`, `processor` that of [cpu]. Keys of the other variant then have no effect and are not a problem.
void read_scenario_tables(TableReader& root, const std::vector<std::string_view>& bad, const ScenarioRobot& robot,
                          const LogicChoice& chosen, std::optional<CpuKind> processor, Scenario& scenario);

}  // namespace armature::cosim
