#include "cosim/scenario/move_text.hpp"

#include <type_traits>

#include "cosim/scenario/moves/kinds.hpp"

namespace armature::cosim {
namespace {

// The result of action(move, entry of its kind).
template <class Action>
auto with_entry(const CommandKind& kind, Action action) {
  return std::visit([&](const auto& move) { return action(move, move_entry<std::remove_cvref_t<decltype(move)>>()); },
                    kind);
}

}  // namespace

std::string move_text(const CommandKind& kind) {
  return with_entry(kind, [](const auto& move, const auto& entry) {
    return std::string{entry.name} + (entry.details ? entry.details(move) : std::string{});
  });
}

bool is_queued(const CommandKind& kind) {
  return with_entry(kind, [](const auto&, const auto& entry) { return entry.queued; });
}

}  // namespace armature::cosim
