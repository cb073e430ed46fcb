// Tables with kinds: a key names the kind, and each kind has keys of its own. The kinds are the alternatives of a
// std::variant.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>

namespace armature::cosim {

// Calls visit(std::type_identity<Kind>{}) for each alternative of the std::variant `Kinds`, in their order.
template <class Kinds, class Visit>
void for_each_kind(Visit visit) {
  [&]<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
    (visit(std::type_identity<std::variant_alternative_t<kIndex, Kinds>>{}), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Kinds>>{});
}

}  // namespace armature::cosim
