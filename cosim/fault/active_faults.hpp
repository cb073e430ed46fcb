// The faults with a duration that have begun and not ended. What they do together follows from this list, so faults of
// one kind may overlap.
#pragma once

#include <algorithm>
#include <variant>
#include <vector>

#include "cosim/fault/fault_spec.hpp"

namespace armature::cosim {

class ActiveFaults {
 public:
  void add(const FaultKind& fault) { list_.push_back(fault); }
  // Removes one that is equal to it. It must be there.
  void remove(const FaultKind& fault) { list_.erase(std::ranges::find(list_, fault)); }

  [[nodiscard]] bool empty() const { return list_.empty(); }

  template <class Kind>
  [[nodiscard]] bool any() const {
    return std::ranges::any_of(list_, [](const FaultKind& fault) { return std::holds_alternative<Kind>(fault); });
  }

  // Calls `see` with each of this kind, in the order in which they began.
  template <class Kind>
  void for_each(const auto& see) const {
    for (const FaultKind& fault : list_) {
      if (const auto* one = std::get_if<Kind>(&fault)) see(*one);
    }
  }

 private:
  std::vector<FaultKind> list_;
};

}  // namespace armature::cosim
