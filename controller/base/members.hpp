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
#include <tuple>
#include <type_traits>

#include "controller/base/pretty_name.hpp"

namespace armature {

template <class Owner, class T>
struct Member {
  using Type = T;
  const char* name;
  T Owner::*at;
};
template <class Owner, class T>
Member(const char*, T Owner::*) -> Member<Owner, T>;

template <class T>
concept HasMembers = requires {
  T::members();
};

// Calls visit(name, member) for each member of `value`, in the order of the list.
template <HasMembers T, class Visit>
constexpr void for_each_member(T& value, Visit visit) {
  std::apply([&](const auto&... member) { (visit(member.name, value.*member.at), ...); },
             std::remove_const_t<T>::members());
}

// `JogEnded` of armature::JogEnded.
template <class T>
[[nodiscard]] constexpr std::string_view type_name_of() noexcept {
  return name_behind(__PRETTY_FUNCTION__, "T = ");
}

}  // namespace armature

// Type::members() is a tuple of Member. A structured binding needs a name for each member, so the second function
// compiles only if all are listed.
#define ARMATURE_MEMBERS(Type, ...)                                                          \
  [[nodiscard]] static constexpr auto members() noexcept {                                   \
    return std::tuple{__VA_OPT__(ARMATURE_EXPAND(ARMATURE_NEXT_MEMBER(Type, __VA_ARGS__)))}; \
  }                                                                                          \
  static constexpr void lists_all_members([[maybe_unused]] const Type& value) noexcept {     \
    __VA_OPT__([[maybe_unused]] const auto& [__VA_ARGS__] = value;)                          \
  }

#define ARMATURE_NEXT_MEMBER(Type, name, ...) \
  ::armature::Member{#name, &Type::name} __VA_OPT__(, ARMATURE_AGAIN ARMATURE_PARENS(Type, __VA_ARGS__))
#define ARMATURE_AGAIN() ARMATURE_NEXT_MEMBER
#define ARMATURE_PARENS ()
// Up to 64 members.
#define ARMATURE_EXPAND(...) ARMATURE_EXPAND3(ARMATURE_EXPAND3(ARMATURE_EXPAND3(ARMATURE_EXPAND3(__VA_ARGS__))))
#define ARMATURE_EXPAND3(...) ARMATURE_EXPAND2(ARMATURE_EXPAND2(ARMATURE_EXPAND2(ARMATURE_EXPAND2(__VA_ARGS__))))
#define ARMATURE_EXPAND2(...) ARMATURE_EXPAND1(ARMATURE_EXPAND1(ARMATURE_EXPAND1(ARMATURE_EXPAND1(__VA_ARGS__))))
#define ARMATURE_EXPAND1(...) __VA_ARGS__
