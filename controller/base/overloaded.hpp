// A visitor made of one lambda for each alternative: std::visit(Overloaded{[](const A&) {}, [](const B&) {}}, variant).
#pragma once

namespace armature {

template <class... Visitors>
struct Overloaded : Visitors... {
  using Visitors::operator()...;
};
template <class... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;  // clang 14 does not deduce aggregates

}  // namespace armature
