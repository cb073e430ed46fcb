// [[fault]]: `at_s`, `kind`, and the keys of each kind, which exist with that kind only.
#include <utility>
#include <vector>

#include "cosim/scenario/tables/fault_kinds.hpp"
#include "cosim/scenario/tables/kind_keys.hpp"
#include "cosim/scenario/tables/tables.hpp"

namespace armature::cosim {

namespace {

Keys<FaultSpec> condition_keys() {
  constexpr double kMaxDeg = 36'000, kMaxDegS = 100'000;
  return {
      named_key("when", &FaultSpec::when,
                "What the fault waits for from `at_s` on. `passes`: the motor of an axis passes a place, in either "
                "direction. `speed`: the set-points of an axis are as fast. `move_begins`: a move begins. These are "
                "judged at each trigger, and the fault begins one clock cycle later. `time`: nothing."),
      key("when_axis", &FaultSpec::when_axis, between(1, kAxes), "This axis.")
          .required()
          .only(when("when", {"passes", "speed"})),
      key("when_deg", &FaultSpec::when_deg, between(-kMaxDeg, kMaxDeg, "deg"), "The place, as a joint angle.")
          .required()
          .only(when("when", {"passes"})),
      key("when_deg_s", &FaultSpec::when_deg_s, above(0, kMaxDegS, "deg/s"), "The speed, in either direction.")
          .required()
          .only(when("when", {"speed"})),
      key("when_move", &FaultSpec::when_move, between(0, 1'000'000),
          "The move, counted from 0 in the order of the file, as messages name it: `move[0]`.")
          .required()
          .only(when("when", {"move_begins"})),
  };
}

}  // namespace

const KeyTable<FaultSpec>& fault_keys() {
  static const KeyTable<FaultSpec> kTable = [] {
    constexpr std::string_view kKindKey = "kind";
    constexpr auto kEntryOf = []<class Kind>(std::type_identity<Kind>) -> const FaultEntry<Kind>& {
      return fault_entry<Kind>();
    };
    KeyTable<FaultSpec> table{
        .text = "Each table injects a fault.",
        .keys = {at_key<FaultSpec>("The fault begins at this time, or later, when a condition holds, see `when`."),
                 kind_key<FaultSpec>(kKindKey, "What fails.", kEntryOf)},
    };
    add_kind_keys(table.keys, kKindKey, kEntryOf);
    table.keys.append(condition_keys());
    return table;
  }();
  return kTable;
}

}  // namespace armature::cosim
