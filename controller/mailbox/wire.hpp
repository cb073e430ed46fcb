// Copies values into blocks and back. Each block has one list of pairs (fields_of.hpp), which Encode and Decode use in
// their direction.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>

#include "controller/core/tag.hpp"
#include "controller/core/units.hpp"
#include "controller/mailbox/block.hpp"

namespace armature::mailbox {

template <class T>
concept Unit = requires(const T& value) {
  typename T::rep;
  value.value();
};

struct Encode {
  template <class Wire, class Value>
  void operator()(Wire& wire, const Value& value) const noexcept {
    if constexpr (std::is_same_v<Value, Tag>) {
      wire = value.word();
    } else if constexpr (Unit<Value>) {
      wire = value.value();
    } else if constexpr (std::is_same_v<Value, Eigen::Vector3d>) {
      for (std::size_t i = 0; i < 3; ++i) wire[i] = value[static_cast<Eigen::Index>(i)];
    } else if constexpr (std::is_same_v<Value, Eigen::Matrix3d>) {
      for (std::size_t i = 0; i < 9; ++i) {
        wire[i] = value(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3));
      }
    } else if constexpr (requires { value.size(); }) {
      static_assert(std::tuple_size_v<Wire> == std::tuple_size_v<Value>);
      for (std::size_t i = 0; i < value.size(); ++i) (*this)(wire[i], value[i]);
    } else {
      static_assert(sizeof(Wire) == sizeof(Value));
      wire = static_cast<Wire>(value);
    }
  }
  template <class Wire, class Value>
  void optional(u8& has, Wire& wire, const std::optional<Value>& value) const noexcept {
    has = value ? 1 : 0;
    if (value) (*this)(wire, *value);
  }
};

struct Decode {
  template <class Wire, class Value>
  void operator()(const Wire& wire, Value& value) const noexcept {
    if constexpr (std::is_same_v<Value, Tag>) {
      value = Tag::from_word(wire);
    } else if constexpr (std::is_same_v<Value, bool>) {
      value = wire != 0;
    } else if constexpr (Unit<Value>) {
      value = Value{wire};
    } else if constexpr (std::is_same_v<Value, Eigen::Vector3d>) {
      for (std::size_t i = 0; i < 3; ++i) value[static_cast<Eigen::Index>(i)] = wire[i];
    } else if constexpr (std::is_same_v<Value, Eigen::Matrix3d>) {
      for (std::size_t i = 0; i < 9; ++i) {
        value(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)) = wire[i];
      }
    } else if constexpr (requires { value.size(); }) {
      static_assert(std::tuple_size_v<Wire> == std::tuple_size_v<Value>);
      for (std::size_t i = 0; i < value.size(); ++i) (*this)(wire[i], value[i]);
    } else {
      static_assert(sizeof(Wire) == sizeof(Value));
      value = static_cast<Value>(wire);
    }
  }
  template <class Wire, class Value>
  void optional(u8 has, const Wire& wire, std::optional<Value>& value) const noexcept {
    value.reset();
    if (has != 0) (*this)(wire, value.emplace());
  }
};

}  // namespace armature::mailbox
