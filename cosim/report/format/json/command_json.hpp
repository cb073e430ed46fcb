// A command as summary.json names it.
#pragma once

#include <string>

#include "controller/base/tag.hpp"
#include "cosim/report/format/json/fact_json.hpp"
#include "cosim/scenario/command_names.hpp"

namespace armature::cosim {

// `command` is its name, and `move` its index if the scenario has it in [[move]].
[[nodiscard]] inline Json command_json(Tag tag, std::string name) {
  const auto index = move_index(tag);
  return {{"command", std::move(name)}, {"move", index ? Json(*index) : Json(nullptr)}};
}
[[nodiscard]] inline Json command_json(Tag tag, const CommandNames& names) {
  return command_json(tag, names.of(tag));
}

}  // namespace armature::cosim
