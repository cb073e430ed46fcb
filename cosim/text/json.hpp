// JSON with its keys in the order of writing.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace armature::cosim {

using Json = nlohmann::ordered_json;

// On one line. What is no UTF-8 becomes the replacement character.
[[nodiscard]] inline std::string compact_text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace armature::cosim
