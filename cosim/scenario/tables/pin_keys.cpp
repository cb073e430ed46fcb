// The pins of the tool: [[input]] and [[expect.output]].
#include <cstddef>
#include <string>
#include <vector>

#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/scenario/tables/tables.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

// Changes are listed in their order; the last of the list is this one.
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
      .text = "Each table changes an input of the tool. All inputs are low before.",
      .keys = {
          at_key<InputSpec>("The input has the level from this time on."),
          pin_key<InputSpec>("The number of the input."),
          level_key<InputSpec>("0 is low, 1 is high. The table must change the level."),
      }};
  return kTable;
}

const KeyTable<OutputChangeSpec>& expected_output_keys() {
  static const KeyTable<OutputChangeSpec> kTable{
      .text =
          "The tables list all changes of the tool's outputs in their order, no more and no fewer. "
          "`output = []` expects no change.",
      .keys = {
          at_key<OutputChangeSpec>("The output changes at this time, within one tick (50 us).").checked(check_order),
          pin_key<OutputChangeSpec>("The number of the output."),
          level_key<OutputChangeSpec>("The level after the change: 0 is low, 1 is high."),
      }};
  return kTable;
}

}  // namespace armature::cosim
