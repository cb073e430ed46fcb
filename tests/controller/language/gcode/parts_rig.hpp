// The parts of the executor of G-code, each after those that it uses, with a sink that keeps their calls.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "controller/language/gcode/execute/cycles.hpp"
#include "controller/language/gcode/execute/motion.hpp"
#include "controller/language/gcode/execute/outputs.hpp"
#include "controller/language/gcode/execute/saved_states.hpp"

namespace armature::test {

class KeepingSink final : public gcode::CanonSink {
 public:
  void on_call(const gcode::CanonCall& call, std::uint32_t line) noexcept override {
    calls.push_back(call);
    lines.push_back(line);
  }

  // The calls since the last clear() are of these kinds, in this order.
  template <class... Kinds>
  [[nodiscard]] bool made() const {
    std::size_t at = 0;
    return calls.size() == sizeof...(Kinds) && (std::holds_alternative<Kinds>(calls[at++]) && ...);
  }
  template <class Kind>
  [[nodiscard]] std::vector<Kind> all() const {
    std::vector<Kind> found;
    for (const gcode::CanonCall& call : calls) {
      if (const auto* one = std::get_if<Kind>(&call)) found.push_back(*one);
    }
    return found;
  }
  template <class Kind>
  [[nodiscard]] Kind last() const {
    return all<Kind>().back();
  }
  void clear() {
    calls.clear();
    lines.clear();
  }

  std::vector<gcode::CanonCall> calls;
  std::vector<std::uint32_t> lines;
};

class NoComputedParameters final : public gcode::ComputedParameters {
 public:
  [[nodiscard]] std::optional<double> computed(std::string_view) const noexcept override { return std::nullopt; }
  [[nodiscard]] std::optional<double> computed(int) const noexcept override { return std::nullopt; }
};

// The words of a line, checked as the executor does it. `active`: the motion mode before the line.
inline gcode::Block block_of(std::string_view text, const gcode::CodeInfo* active = nullptr) {
  const NoComputedParameters computed;
  const gcode::Parameters parameters{computed};
  gcode::SourceLine line;
  gcode::Assignments assignments;
  gcode::Block block;
  const bool readable = !line.read(text);
  gcode::ValueReader reader{line, parameters};
  if (!readable || !read_block(reader, block, assignments) || check_block(block, active)) {
    throw std::invalid_argument{std::string{text}};
  }
  return block;
}

struct GcodeParts {
  GcodeParts() = default;
  GcodeParts(const GcodeParts&) = delete;
  GcodeParts& operator=(const GcodeParts&) = delete;

  // With the motion mode of the parts.
  [[nodiscard]] gcode::Block block(std::string_view text) const { return block_of(text, motion.active()); }

  KeepingSink sink;
  gcode::LineCalls calls{sink};
  NoComputedParameters computed;
  gcode::Parameters parameters{computed};
  gcode::Modes modes{calls};
  gcode::Spindle spindle{calls};
  gcode::Coolant coolant{calls};
  gcode::Overrides overrides{calls};
  gcode::Tools tools{calls, spindle};
  gcode::Coordinates coordinates{calls, modes, tools, parameters};
  gcode::SavedStates saved_states{modes, spindle, coolant, overrides, coordinates};
  gcode::Cycles cycles{calls, modes, spindle, overrides, coordinates};
  gcode::Motion motion{calls, modes, coordinates, cycles};
};

// What is wrong; nothing if all is well.
inline std::optional<gcode::ErrorCode> code_of(const gcode::Failure& failure) {
  return failure ? std::optional{failure->code} : std::nullopt;
}

}  // namespace armature::test
