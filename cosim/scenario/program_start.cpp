#include "cosim/scenario/program_start.hpp"

#include <algorithm>
#include <variant>

#include "cosim/scenario/move_text.hpp"

namespace armature::cosim {
namespace {

// A stop, a hold or an override acts on a motion that is under way, which may be one of the program.
bool brings_the_arm(const CommandKind& kind) {
  return is_queued(kind) || std::holds_alternative<JogSpec>(kind) || std::holds_alternative<HomeSpec>(kind);
}

}  // namespace

double program_start_s(const Scenario& scenario) {
  double start_s = scenario.program_at_s.value_or(0.0);
  for (const CommandSpec& move : scenario.moves) {
    if (brings_the_arm(move.kind)) start_s = std::max(start_s, move.at_s);
  }
  for (const StreamSpec& stream : scenario.streams) start_s = std::max(start_s, stream.at_s);
  return start_s;
}

}  // namespace armature::cosim
