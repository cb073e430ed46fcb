// The pins of the tool: [[input]] and [[expect.output]].
#include <cstddef>
#include <string>
#include <string_view>
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
          key("tcp_mm", &OutputChangeSpec::tcp_mm, between(-kMaxPlaceMm, kMaxPlaceMm, "mm"),
              "Position of the tool centre point of the set-points at that time, in the base frame.")
              .needs(Needs::kKinematics),
          key("tcp_tolerance_mm", &OutputChangeSpec::tcp_tolerance_mm, between(0, kMaxPlaceMm, "mm"),
              "Tolerance of `tcp_mm`, as a distance.")
              .only(beside("tcp_mm")),
      }};
  return kTable;
}

const KeyTable<PathOutputSpec>& path_output_keys() {
  constexpr double kMaxOffsetS = 600;
  // At most one distance.
  constexpr auto kCheck = [](TableReader& table, const KeyContext&, PathOutputSpec&) {
    std::string_view first;
    for (const std::string_view name : {"before_mm", "after_mm", "before_s", "after_s"}) {
      if (!table.has(name)) continue;
      if (!first.empty()) table.problem(name, "cannot be used together with " + std::string{first});
      if (first.empty()) first = name;
    }
  };
  const auto length = [](std::string_view name, auto member, std::string_view text) {
    return key(name, member, between(0, kMaxPlaceMm, "mm"), text);
  };
  const auto time = [](std::string_view name, auto member, std::string_view text) {
    return key(name, member, between(0, kMaxOffsetS, "s"), text);
  };
  static const KeyTable<PathOutputSpec> kTable{
      .text =
          "Each table switches an output of the tool at a place of a path or at a time of a joint move, without a "
          "stop: within one tick (50 us) of the moment at which the set-points pass the place. Without a distance or "
          "time the place is the start or the end itself. It may be on another move of the same chain. At most 4 "
          "tables for a move, and 32 for a chain: the tool stops before a move that has more.",
      .keys =
          {
              pin_key<PathOutputSpec>("Number of the output."),
              level_key<PathOutputSpec>("New level: 0 is low, 1 is high."),
              key("from", &PathOutputSpec::from, one_of({"start", "end"}),
                  "The point of the move that distances and times are measured from. A joint move with a blend ends "
                  "where "
                  "the next one begins."),
              length("before_mm", &PathOutputSpec::before_mm,
                     "Distance before that point, along the paths; not with `joint`. Rounded corners do not change it, "
                     "and the middle of a "
                     "rounded corner counts as its corner point."),
              length("after_mm", &PathOutputSpec::after_mm, "Distance behind that point, likewise."),
              time("before_s", &PathOutputSpec::before_s,
                   "Time before that point at the planned speed. It gives a place on the path: under an override the "
                   "output is switched at the same place, which is earlier by more time."),
              time("after_s", &PathOutputSpec::after_s, "Time after that point, likewise."),
          },
      .checks = {{{}, kCheck}}};
  return kTable;
}

}  // namespace armature::cosim
