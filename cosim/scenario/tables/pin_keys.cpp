// The pins of the tool: [[input]] and [[expect.output]].
#include <cstddef>
#include <string>
#include <vector>

#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/scenario/tables/tables.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

// Changes must be in the order of time. `output` is the last one of the list so far.
std::string check_order(const OutputChangeSpec& output, const KeyContext& context) {
  if (std::string why = outside_run(output.at_s, *context.scenario); !why.empty()) return why;
  const std::vector<OutputChangeSpec>& all = *context.scenario->expect.outputs;
  if (all.size() < 2 || output.at_s >= all[all.size() - 2].at_s) return {};
  return "expected at least " + number_text(all[all.size() - 2].at_s) +
         ", as the changes are listed in their order, found " + number_text(output.at_s);
}

}  // namespace

const KeyTable<InputSpec>& input_keys() {
  static const KeyTable<InputSpec> kTable{
      .text = "Each table changes the level of one input of the tool. All inputs are low at the start.",
      .keys = {
          at_key<InputSpec>("Time at which the level changes."),
          pin_key<InputSpec>("Number of the input."),
          level_key<InputSpec>("New level: 0 is low, 1 is high. It must differ from the level before."),
      }};
  return kTable;
}

const KeyTable<OutputChangeSpec>& expected_output_keys() {
  static const KeyTable<OutputChangeSpec> kTable{
      .text =
          "The tables list all expected changes of the tool's outputs, in the order of time. `output = []` expects no "
          "change.",
      .keys = {
          at_key<OutputChangeSpec>("Time of the change, with a tolerance of one tick (50 us).").checked(check_order),
          pin_key<OutputChangeSpec>("Number of the output."),
          level_key<OutputChangeSpec>("Level after the change: 0 is low, 1 is high."),
      }};
  return kTable;
}

}  // namespace armature::cosim
