// [[fault]]: `at_s`, `kind`, and the keys of each kind, which exist with that kind only.
#include "cosim/scenario/tables/fault_kinds.hpp"
#include "cosim/scenario/tables/kind_keys.hpp"
#include "cosim/scenario/tables/tables.hpp"

namespace armature::cosim {

const KeyTable<FaultSpec>& fault_keys() {
  static const KeyTable<FaultSpec> kTable = [] {
    constexpr std::string_view kKindKey = "kind";
    constexpr auto kEntryOf = []<class Kind>(std::type_identity<Kind>) -> const FaultEntry<Kind>& {
      return fault_entry<Kind>();
    };
    KeyTable<FaultSpec> table{
        .text = "Each table injects a fault.",
        .keys = {at_key<FaultSpec>("The fault begins at this time."),
                 kind_key<FaultSpec>(kKindKey, "What fails.", kEntryOf)},
    };
    add_kind_keys(table.keys, kKindKey, kEntryOf);
    return table;
  }();
  return kTable;
}

}  // namespace armature::cosim
