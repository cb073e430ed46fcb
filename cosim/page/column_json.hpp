// A column of integers in the data of a page.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "cosim/page/column_code.hpp"
#include "cosim/text/json.hpp"

namespace armature::cosim {

// `digits`: the values are in units of 10^-digits.
[[nodiscard]] inline Json column_json(const std::string& name, int digits, const std::vector<std::int64_t>& values) {
  ColumnCode code = column_code(values);
  return {{"name", name},
          {"digits", digits},
          {"rows", values.size()},
          {"order", code.order},
          {"data", std::move(code.text)}};
}

}  // namespace armature::cosim
