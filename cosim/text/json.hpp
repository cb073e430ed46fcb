// JSON with its keys in the order of writing.
#pragma once

#include <nlohmann/json.hpp>

namespace armature::cosim {

using Json = nlohmann::ordered_json;

}  // namespace armature::cosim
