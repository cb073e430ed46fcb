#include "cosim/scenario/scenario_tables.hpp"

namespace armature::cosim {

void read_pin(TableReader& table, std::int64_t& pin, bool& level) {
  table.read("pin", pin, between(1, kToolPins), Need::kRequired);
  std::int64_t bit = 0;
  table.read("level", bit, between(0, 1), Need::kRequired);
  level = bit != 0;
}

void read_input(TableReader& table, const Scenario& scenario, InputSpec& input) {
  input.line = table.line();
  read_at(table, scenario.duration_s, input.at_s);
  read_pin(table, input.pin, input.level);
}

void read_expected_output(TableReader& table, const Scenario& scenario, OutputChangeSpec& output) {
  read_at(table, scenario.duration_s, output.at_s);
  read_pin(table, output.pin, output.level);
}

}  // namespace armature::cosim
