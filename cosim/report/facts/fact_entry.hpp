// How an entry of the list of facts names its value and its expectations: by members of RunFacts and ExpectSpec.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "cosim/report/facts/fact.hpp"
#include "cosim/report/measure/tool_point.hpp"

namespace armature::cosim {

// ---- a member as a FactValue; PerAxis<T> keeps only the axes that the robot has
inline FactValue to_value(std::int64_t value, std::size_t) {
  return value;
}
inline FactValue to_value(double value, std::size_t) {
  return value;
}
inline FactValue to_value(Cycles value, std::size_t) {
  return value.value();
}
inline FactValue to_value(const std::string& value, std::size_t) {
  return value;
}
inline FactValue to_value(std::string_view value, std::size_t) {
  return std::string{value};
}
inline FactValue to_value(const ToolPeak& peak, std::size_t) {
  return peak.value;
}
template <class T>
FactValue to_value(const PerAxis<T>& values, std::size_t axis_count) {
  return OfAxes<T>{{values.begin(), values.begin() + static_cast<std::ptrdiff_t>(axis_count)}};
}
template <class T>
FactValue to_value(const std::vector<T>& values, std::size_t) {
  return values;
}
inline FactValue to_value(const Eigen::Vector3d& value, std::size_t) {
  return Point{value};
}
inline FactValue to_value(const std::array<double, 3>& mm, std::size_t) {
  return Point{Eigen::Vector3d{mm.data()}};
}
inline FactValue to_value(const Eigen::Matrix3d& value, std::size_t) {
  return Orientation{value, rpy_deg(value)};
}
template <class T>
FactValue to_value(const std::optional<T>& value, std::size_t axis_count) {
  return value ? to_value(*value, axis_count) : FactValue{};
}

// The value of a member of RunFacts, or what a member function returns.
template <auto kMember>
FactValue measured(const RunFacts& facts) {
  if constexpr (std::is_member_function_pointer_v<decltype(kMember)>) {
    return to_value((facts.*kMember)(), facts.axis_count);
  } else if constexpr (std::is_same_v<decltype(kMember), std::optional<PathDeviation> RunFacts::*>) {
    const std::optional<PathDeviation>& value = facts.*kMember;
    return value ? NamedDeviation{*value, facts.names.of(value->move)} : FactValue{};
  } else {
    return to_value(facts.*kMember, facts.axis_count);
  }
}

// ---- expectations
template <auto kMember>
std::optional<FactValue> wanted_member(const ExpectSpec& expect, std::size_t axis_count) {
  if (!(expect.*kMember)) return std::nullopt;
  return to_value(*(expect.*kMember), axis_count);
}
template <auto kMember>
Expectation equal(std::string_view key) {
  return {.key = key, .relation = Relation::kEqual, .wanted = wanted_member<kMember>};
}
template <auto kMember>
Expectation at_most(std::string_view key) {
  return {.key = key, .relation = Relation::kAtMost, .wanted = wanted_member<kMember>};
}
template <auto kMember>
Expectation at_least(std::string_view key) {
  return {.key = key, .relation = Relation::kAtLeast, .wanted = wanted_member<kMember>};
}
template <auto kMember, auto kTolerance>
Expectation within(std::string_view key, std::string_view tolerance_key) {
  return {.key = key,
          .relation = Relation::kWithin,
          .wanted = wanted_member<kMember>,
          .tolerance = [](const ExpectSpec& expect) { return expect.*kTolerance; },
          .tolerance_key = tolerance_key};
}

}  // namespace armature::cosim
