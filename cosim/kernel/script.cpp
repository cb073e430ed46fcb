#include "cosim/kernel/script.hpp"

#include <algorithm>

#include "controller/base/timebase.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {

Script::Script(const Scenario& scenario) {
  for (const FaultSpec& fault : scenario.faults) {
    const Cycles begin = to_cycles(fault.at_s);
    entries_.push_back({begin, fault});
    if (const auto duration_s = fault_duration_s(fault.kind)) {
      // Rounding must not take a fault of one cycle away.
      entries_.push_back({std::max(begin + Cycles{1}, to_cycles(fault.at_s + *duration_s)), FaultEnd{fault}});
    }
  }
  for (const InputSpec& input : scenario.inputs) entries_.push_back({to_cycles(input.at_s), input});
  for (const CommandSpec& move : scenario.moves) entries_.push_back({to_cycles(move.at_s), move});
  for (std::size_t i = 0; i < scenario.streams.size(); ++i) {
    const StreamSpec& stream = scenario.streams[i];
    for (std::size_t point = 0; point < stream.points.size(); ++point) {
      entries_.push_back(
          {to_cycles(stream.at_s) + Cycles{kTickCycles * stream.points[point].ticks}, StreamStep{i, point}});
    }
  }
  if (scenario.conveyor) {
    for (const double at_s : scenario.conveyor->part_s) entries_.push_back({to_cycles(at_s), PartStep{}});
  }
  std::ranges::stable_sort(entries_, {}, &Entry::at);
}

std::optional<Cycles> Script::next_event() const {
  if (next_ == entries_.size()) return std::nullopt;
  return entries_[next_].at;
}

std::optional<ScriptAction> Script::pop_due(Cycles now) {
  if (next_ == entries_.size() || entries_[next_].at > now) return std::nullopt;
  return entries_[next_++].action;
}

}  // namespace armature::cosim
