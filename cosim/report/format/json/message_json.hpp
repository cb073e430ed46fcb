// A message of the controller as JSON, from its list of members: for events that have no form of their own.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>

#include "controller/base/angle_units.hpp"
#include "controller/base/members.hpp"
#include "controller/base/tag.hpp"
#include "controller/base/units.hpp"
#include "controller/base/words.hpp"
#include "cosim/report/format/json/fact_json.hpp"

namespace armature::cosim {

// `deviation_deg` of `deviation_rad`, whose values are converted; `taken_ticks` of a duration `taken`.
template <class T>
[[nodiscard]] std::string json_key(std::string_view member) {
  std::string key{member};
  if (const std::size_t at = key.find("_rad"); at != std::string::npos) key.replace(at, 4, "_deg");
  if (std::is_same_v<T, Ticks> && !key.ends_with("tick")) key += "_ticks";
  return key;
}

template <class T>
[[nodiscard]] Json message_json(const T& value, double scale = 1.0) {
  if constexpr (std::is_same_v<T, Tag>) {
    return value.number();
  } else if constexpr (std::is_enum_v<T>) {
    return word_of(value);
  } else if constexpr (std::is_floating_point_v<T>) {
    return value * scale;
  } else if constexpr (std::is_arithmetic_v<T>) {
    return value;
  } else if constexpr (std::is_same_v<T, Radians>) {
    return value.value() * kDegPerRad;
  } else if constexpr (Unit<T>) {
    return value.value();
  } else if constexpr (HasMembers<T>) {
    Json json = Json::object();
    for_each_member(value, [&]<class Part>(std::string_view name, const Part& part) {
      const bool angle = name.find("_rad") != std::string_view::npos;
      json[json_key<std::remove_const_t<Part>>(name)] = message_json(part, angle ? kDegPerRad : 1.0);
    });
    return json;
  } else if constexpr (requires { value.has_value(); }) {
    return value ? message_json(*value, scale) : Json(nullptr);
  } else {
    Json array = Json::array();
    for (const auto& element : value) array.push_back(message_json(element, scale));
    return array;
  }
}

}  // namespace armature::cosim
