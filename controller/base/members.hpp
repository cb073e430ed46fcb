// The members of a message, listed once, beside them:
//
//   struct FaultCleared {
//     Ticks tick{};
//     ARMATURE_MEMBERS(FaultCleared, tick)
//   };
//
// From this list follow the bytes in the memory that the controller shares with its host, LAYOUT.md, JSON and the text
// of the log. A list without one of the members does not compile.
#pragma once

#include <string_view>

#include "controller/base/pretty_name.hpp"

namespace armature {

template <class T>
struct NamedType {
  using Type = T;
  const char* name;
};

template <class T>
concept HasMembers = requires {
  &T::lists_all_members;
};

// Calls visit(name, member) for each member of `value`, in the order of the list.
template <HasMembers T, class Visit>
constexpr void for_each_member(T& value, Visit visit) {
  T::visit_members(value, visit);
}

// Calls visit(NamedType) for each member of T, in the order of the list.
template <HasMembers T, class Visit>
constexpr void for_each_member_type(Visit visit) {
  T::visit_types(visit);
}

// `JogEnded` of armature::JogEnded.
template <class T>
[[nodiscard]] constexpr std::string_view type_name_of() noexcept {
  return name_behind(__PRETTY_FUNCTION__, "T = ");
}

}  // namespace armature

// Calls, and no tuple of the members: a compiler takes a multiple of the time for a tuple. A structured binding needs a
// name for each member, so the last function compiles only if all are listed.
#define ARMATURE_MEMBERS(Type, ...)                                                                   \
  template <class Value, class Visit>                                                                 \
  static constexpr void visit_members([[maybe_unused]] Value& value, [[maybe_unused]] Visit& visit) { \
    __VA_OPT__(ARMATURE_EXPAND(ARMATURE_VISIT_MEMBER(__VA_ARGS__)))                                   \
  }                                                                                                   \
  template <class Visit>                                                                              \
  static constexpr void visit_types([[maybe_unused]] Visit& visit) {                                  \
    __VA_OPT__(ARMATURE_EXPAND(ARMATURE_VISIT_TYPE(Type, __VA_ARGS__)))                               \
  }                                                                                                   \
  static constexpr void lists_all_members([[maybe_unused]] const Type& value) noexcept {              \
    __VA_OPT__([[maybe_unused]] const auto& [__VA_ARGS__] = value;)                                   \
  }

#define ARMATURE_VISIT_MEMBER(name, ...) \
  visit(#name, value.name);              \
  __VA_OPT__(ARMATURE_VISIT_MEMBER_AGAIN ARMATURE_PARENS(__VA_ARGS__))
#define ARMATURE_VISIT_MEMBER_AGAIN() ARMATURE_VISIT_MEMBER
#define ARMATURE_VISIT_TYPE(Type, name, ...)                 \
  visit(::armature::NamedType<decltype(Type::name)>{#name}); \
  __VA_OPT__(ARMATURE_VISIT_TYPE_AGAIN ARMATURE_PARENS(Type, __VA_ARGS__))
#define ARMATURE_VISIT_TYPE_AGAIN() ARMATURE_VISIT_TYPE
#define ARMATURE_PARENS ()
// Up to 64 members.
#define ARMATURE_EXPAND(...) ARMATURE_EXPAND3(ARMATURE_EXPAND3(ARMATURE_EXPAND3(ARMATURE_EXPAND3(__VA_ARGS__))))
#define ARMATURE_EXPAND3(...) ARMATURE_EXPAND2(ARMATURE_EXPAND2(ARMATURE_EXPAND2(ARMATURE_EXPAND2(__VA_ARGS__))))
#define ARMATURE_EXPAND2(...) ARMATURE_EXPAND1(ARMATURE_EXPAND1(ARMATURE_EXPAND1(ARMATURE_EXPAND1(__VA_ARGS__))))
#define ARMATURE_EXPAND1(...) __VA_ARGS__
