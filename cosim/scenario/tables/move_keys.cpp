// [[move]]: `at_s`, `type`, and the keys of each type, which exist with that type only.
#include "cosim/scenario/tables/kind_keys.hpp"
#include "cosim/scenario/tables/move_kinds.hpp"
#include "cosim/scenario/tables/tables.hpp"

namespace armature::cosim {

const KeyTable<MoveSpec>& move_keys() {
  static const KeyTable<MoveSpec> kTable = [] {
    constexpr std::string_view kTypeKey = "type";
    constexpr auto kEntryOf = []<class Kind>(std::type_identity<Kind>) -> const MoveEntry<Kind>& {
      return move_entry<Kind>();
    };
    KeyTable<MoveSpec> table{
        .text = "Each table is one command for the controller.",
        .keys = {at_key<MoveSpec>("Time at which the controller gets the command."),
                 kind_key<MoveSpec>(kTypeKey, kEntryOf)},
        .tables = {tables("output", &MoveSpec::outputs, path_output_keys(), PathOutputs::kMax)},
        .checks = {{{kTypeKey},
                    [](TableReader& reader, const KeyContext&, MoveSpec& move) {
                      if (move.outputs.empty() || path_of(move.kind) != nullptr) return;
                      reader.problem("output", "allowed only with a path of the tool");
                    }}},
    };
    add_kind_keys(table.keys, kTypeKey, kEntryOf);
    return table;
  }();
  return kTable;
}

}  // namespace armature::cosim
