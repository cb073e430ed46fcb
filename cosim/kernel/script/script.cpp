#include "cosim/kernel/script/script.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "controller/base/timebase.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

// The order at equal times, by ScriptAction::index().
constexpr std::array kRanks{2, 0, 0, 1, 3, 4};
static_assert(kRanks.size() == std::variant_size_v<ScriptAction>);

int rank_of(const ScriptAction& action) {
  return kRanks.at(action.index());
}

// Rounding must not take a fault of one cycle away.
Cycles end_of(const FaultSpec& fault, double duration_s) {
  return std::max(to_cycles(fault.at_s) + Cycles{1}, to_cycles(fault.at_s + duration_s));
}

}  // namespace

Script::Script(const Scenario& scenario) {
  for (const FaultSpec& fault : scenario.faults) {
    if (fault.when != FaultWhen::kTime) continue;  // FaultConditions
    entries_.push_back({to_cycles(fault.at_s), fault});
    if (const auto duration_s = fault_duration_s(fault.kind)) {
      entries_.push_back({end_of(fault, *duration_s), FaultEnd{fault}});
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

void Script::insert(Cycles at, const FaultSpec& fault) {
  insert(Entry{at, fault});
  if (const auto duration_s = fault_duration_s(fault.kind)) {
    insert(Entry{at + std::max(Cycles{1}, to_cycles(*duration_s)), FaultEnd{fault}});
  }
}

std::optional<Cycles> Script::next_event() const {
  if (next_ == entries_.size()) return std::nullopt;
  return entries_[next_].at;
}

std::optional<ScriptAction> Script::pop_due(Cycles now) {
  if (next_ == entries_.size() || entries_[next_].at > now) return std::nullopt;
  return entries_[next_++].action;
}

void Script::add(const FaultSpec& fault) {
  insert(Entry{to_cycles(fault.at_s), fault});
  if (const auto duration_s = fault_duration_s(fault.kind)) insert(Entry{end_of(fault, *duration_s), FaultEnd{fault}});
}

void Script::add(const InputSpec& input) {
  insert(Entry{to_cycles(input.at_s), input});
}

void Script::add(const CommandSpec& command) {
  forget_past();
  insert(Entry{to_cycles(command.at_s), command});
}

void Script::add(Cycles at, const StreamStep& step) {
  forget_past();
  insert(Entry{at, step});
}

// A program that sends commands for hours needs no memory for those that are given. The last one stays, for
// last_event().
void Script::forget_past() {
  constexpr std::size_t kKept = 1'000;
  if (next_ < kKept) return;
  entries_.erase(entries_.begin(), entries_.begin() + static_cast<std::ptrdiff_t>(next_ - 1));
  next_ = 1;
}

void Script::end(const FaultSpec& fault, Cycles now) {
  const auto is_its_end = [&fault](const Entry& entry) {
    const auto* end = std::get_if<FaultEnd>(&entry.action);
    return end != nullptr && end->fault == fault;
  };
  const auto found = std::find_if(entries_.begin() + static_cast<std::ptrdiff_t>(next_), entries_.end(), is_its_end);
  if (found == entries_.end()) return;
  Entry entry = std::move(*found);
  entries_.erase(found);
  entry.at = std::max(now, to_cycles(fault.at_s) + Cycles{1});
  insert(entry);
}

void Script::insert(const Entry& entry) {
  const auto is_before = [](const Entry& a, const Entry& b) {
    return a.at != b.at ? a.at < b.at : rank_of(a.action) < rank_of(b.action);
  };
  entries_.insert(
      std::upper_bound(entries_.begin() + static_cast<std::ptrdiff_t>(next_), entries_.end(), entry, is_before), entry);
}

}  // namespace armature::cosim
