#include <cstddef>
#include <string>
#include <vector>

#include "cosim/scenario/scenario_tables.hpp"
#include "cosim/text/number_text.hpp"

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

void require_changes(TableReader& root, const std::vector<InputSpec>& inputs) {
  std::size_t index = 0;
  root.tables("input", [&](TableReader& table) {
    table.ignore_rest();
    const InputSpec& input = inputs[index++];
    const InputSpec* before = nullptr;
    for (const InputSpec& other : inputs) {
      const bool earlier = other.at_s < input.at_s || (other.at_s == input.at_s && &other < &input);
      if (other.pin == input.pin && earlier && (before == nullptr || other.at_s >= before->at_s)) before = &other;
    }
    const std::string pin = "pin " + std::to_string(input.pin);
    if (before != nullptr && before->at_s == input.at_s) {
      table.problem("at_s", "line " + std::to_string(before->line) + " changes " + pin + " at the same time");
    } else if (input.level == (before != nullptr && before->level)) {
      table.problem("level", "has no effect, " + pin + " is " + (input.level ? "high" : "low") + " already");
    }
  });
}

void read_expected_output(TableReader& table, double duration_s, std::vector<OutputChangeSpec>& outputs) {
  const std::size_t problems = table.problem_count();
  OutputChangeSpec output;
  read_at(table, duration_s, output.at_s);
  read_pin(table, output.pin, output.level);
  if (table.problem_count() == problems && !outputs.empty() && output.at_s < outputs.back().at_s) {
    table.problem("at_s", "expected at least " + number_text(outputs.back().at_s) +
                              ", as the changes are listed in their order, found " + number_text(output.at_s));
  }
  outputs.push_back(output);
}

}  // namespace armature::cosim
