// The values behind the keyword of an O-word.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/language/gcode/flow/flow_index.hpp"
#include "controller/language/gcode/reader/error.hpp"
#include "controller/language/gcode/reader/parameters.hpp"
#include "controller/language/gcode/reader/value_reader.hpp"

namespace armature::gcode {

struct OWordValues {
  std::array<double, Parameters::kLocals> list{};
  std::size_t count = 0;
  std::uint16_t name = FlowIndex::kComputed;  // that is called, by its index; kComputed: no O-word has this name
  std::int32_t turns = 1;                     // of M98
};

// `reader` is at the O-word, which is one of `index`.
[[nodiscard]] Failure read_values(const OWord& word, const FlowIndex& index, ValueReader& reader,
                                  OWordValues& values) noexcept;

}  // namespace armature::gcode
