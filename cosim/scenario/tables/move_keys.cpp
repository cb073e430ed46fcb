// [[move]]: `at_s`, `type`, and the keys of each type, which exist with that type only.
#include <algorithm>
#include <variant>

#include "cosim/scenario/moves/kinds.hpp"
#include "cosim/scenario/tables/kind_keys.hpp"
#include "cosim/scenario/tables/tables.hpp"

namespace armature::cosim {

const KeyTable<CommandSpec>& move_keys() {
  static const KeyTable<CommandSpec> kTable = [] {
    constexpr std::string_view kTypeKey = "type";
    constexpr auto kEntryOf = []<class Kind>(std::type_identity<Kind>) -> const MoveEntry<Kind>& {
      return move_entry<Kind>();
    };
    KeyTable<CommandSpec> table{
        .text = "Each table is one command for the controller.",
        .keys = {at_key<CommandSpec>("Time at which the controller gets the command."),
                 kind_key<CommandSpec>(kTypeKey, "What the controller does.", kEntryOf)},
        .tables = {tables("output", &CommandSpec::outputs, path_output_keys(), PathOutputs::kMax)},
        .checks = {{{kTypeKey},
                    [](TableReader& reader, const KeyContext&, CommandSpec& move) {
                      if (move.outputs.empty()) return;
                      if (std::holds_alternative<PolylineSpec>(move.kind)) {
                        reader.problem("output", "not allowed with type = \"polyline\"");
                      }
                      if (const PathSpec* path = path_of(move.kind)) {
                        if (path->pose.frame != kConveyorFrame.index) return;
                        return reader.problem("output", "not allowed with frame = \"conveyor\"");
                      }
                      const auto* joint = std::get_if<JointSpec>(&move.kind);
                      const auto in_mm = [](const PathOutputSpec& output) {
                        return output.before_mm || output.after_mm;
                      };
                      if (joint == nullptr || joint->when == JointSpec::When::kNow) {
                        reader.problem("output", "allowed only with a move of the arm that does not begin at once");
                      } else if (std::ranges::any_of(move.outputs, in_mm)) {
                        reader.problem("output",
                                       "expected before_s or after_s with type = \"joint\", found a distance in mm");
                      }
                    }}},
    };
    add_kind_keys(table.keys, kTypeKey, kEntryOf);
    return table;
  }();
  return kTable;
}

}  // namespace armature::cosim
