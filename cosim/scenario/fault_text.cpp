#include "cosim/scenario/fault_text.hpp"

#include <type_traits>

#include "cosim/scenario/tables/fault_kinds.hpp"

namespace armature::cosim {
namespace {

// The result of action(fault, entry of its kind).
template <class Action>
auto with_entry(const FaultKind& kind, Action action) {
  return std::visit(
      [&](const auto& fault) { return action(fault, fault_entry<std::remove_cvref_t<decltype(fault)>>()); }, kind);
}

}  // namespace

std::string_view fault_kind_name(const FaultKind& kind) {
  return with_entry(kind, [](const auto&, const auto& entry) { return entry.name; });
}

std::string fault_text(const FaultSpec& fault) {
  return with_entry(fault.kind,
                    [](const auto& kind, const auto& entry) { return std::string{entry.name} + entry.details(kind); });
}

std::vector<NamedValue> fault_parameters(const FaultKind& kind) {
  return with_entry(kind, [](const auto& fault, const auto& entry) { return entry.keys.values(fault); });
}

}  // namespace armature::cosim
