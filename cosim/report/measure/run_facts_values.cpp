// The values of a run that follow from its measurements.
#include <algorithm>
#include <set>

#include "controller/base/angle_units.hpp"
#include "cosim/report/measure/run_facts.hpp"
#include "cosim/text/names.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {

std::string_view RunFacts::outcome() const {
  return controller_silent ? std::string_view{outcomes().back()} : outcome_of(end_fault);
}

// Before its first trigger the controller needs less than kStartTicks.
std::int64_t RunFacts::missing_ticks() const {
  constexpr std::int64_t kStartTicks = 4;
  const std::int64_t due = first_trigger_at ? (cycles - first_trigger_at->at).value() / kTickCycles + 1
                                            : cycles.value() / kTickCycles - kStartTicks;
  return std::max<std::int64_t>(0, due - ticks);
}

std::int64_t RunFacts::unanswered_faults() const {
  return std::ranges::count(injected_faults, false, &InjectedFault::answered);
}

std::optional<std::int64_t> RunFacts::stop_ticks() const {
  std::optional<std::int64_t> longest;
  for (const InjectedFault& fault : injected_faults) longest = std::max(longest, fault.stop_ticks());
  return longest;
}

std::string_view RunFacts::bus_error() const {
  return bus_error_name(bus_aborts.empty() ? BusError::kNone : bus_aborts.front().error);
}

double RunFacts::simulated_s() const {
  return to_seconds(cycles);
}

std::string_view RunFacts::program_end() const {
  if (!names.has_program()) return {};
  const ProgramEvent* last = program_last();
  if (last == nullptr) return "waiting";
  using enum ProgramNoted::Kind;
  const ProgramNoted::Kind kind = last->note.kind;
  return kind == kLine || kind == kMessage || kind == kResumed ? "running" : word_of(kind);
}

const ProgramEvent* RunFacts::program_last() const {
  return program_events.empty() ? nullptr : &program_events.back();
}

std::optional<std::uint32_t> RunFacts::program_place() const {
  const ProgramEvent* last = program_last();
  if (last == nullptr) return std::nullopt;
  const auto is_of_program = [](const MoveStarted& move) { return move.tag.source() == Source::kProgram; };
  const auto move = std::find_if(moves.rbegin(), moves.rend(), is_of_program);
  return program_end() == "running" && move != moves.rend() ? move->tag.number() : last->note.place;
}

std::vector<std::string> RunFacts::program_messages() const {
  std::vector<std::string> messages;
  for (const ProgramEvent& event : program_events) {
    if (event.note.kind == ProgramNoted::Kind::kMessage) messages.emplace_back(event.note.view());
  }
  return messages;
}

std::vector<std::int64_t> RunFacts::high_outputs() const {
  std::set<std::int64_t> high;
  for (const OutputChange& change : outputs) {
    if (change.level) {
      high.insert(change.pin);
    } else {
      high.erase(change.pin);
    }
  }
  return {high.begin(), high.end()};
}

double RunFacts::max_stream_deviation_deg() const {
  return *std::ranges::max_element(stream_deviation_deg);
}

std::int64_t RunFacts::blended_moves() const {
  return std::ranges::count_if(moves, &MoveStarted::continues);
}

std::int64_t RunFacts::unasked_stops() const {
  return std::ranges::count_if(moves, &MoveStarted::unasked_stop);
}

const MoveStarted* RunFacts::most_stretched() const {
  return moves.empty() ? nullptr : &*std::ranges::max_element(moves, {}, &MoveStarted::stretch);
}

double RunFacts::largest_stretch() const {
  const MoveStarted* move = most_stretched();
  return move == nullptr ? 1 : move->stretch;
}

double RunFacts::largest_residual_deg() const {
  double largest_rad = 0;
  for (const MoveStarted& move : moves) largest_rad = std::max(largest_rad, move.residual_rad);
  return largest_rad * kDegPerRad;
}

std::optional<bool> RunFacts::blended_with_next(std::size_t i) const {
  if (i + 1 < moves.size() && moves[i + 1].continues) return true;
  const std::optional<std::uint32_t> index = move_index(moves[i].tag);
  if (!index || std::ranges::find(blends_asked_for, *index) == blends_asked_for.end()) return std::nullopt;
  if (!taken_ticks[i]) return std::nullopt;  // it did not reach its end
  return false;
}

}  // namespace armature::cosim
