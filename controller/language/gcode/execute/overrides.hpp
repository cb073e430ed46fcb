// Which overrides of the operator hold: M48 to M53.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "controller/language/gcode/canon/line_calls.hpp"
#include "controller/language/gcode/reader/block.hpp"

namespace armature::gcode {

class Overrides {
 public:
  using Kind = EnableOverride::Kind;
  using Values = std::array<bool, 4>;  // by Kind

  explicit Overrides(LineCalls& calls) noexcept : calls_(calls) {}

  [[nodiscard]] const Values& active() const noexcept { return active_; }
  [[nodiscard]] bool is_on(Kind kind) const noexcept { return active_[static_cast<std::size_t>(kind)]; }
  [[nodiscard]] std::optional<double> value_of(std::string_view name) const noexcept;

  void begin_program() noexcept { active_ = kAtStart; }
  // The override of the feed is on, the others stay.
  void end_program() noexcept;

  [[nodiscard]] Failure set(const Block& block) noexcept;
  // Makes the calls of what changes. Adaptive feed stays as it is.
  void restore(const Values& to) noexcept;

 private:
  static constexpr Values kAtStart{true, true, false, true};

  void turn(Kind kind, bool on) noexcept;

  LineCalls& calls_;
  Values active_ = kAtStart;
};

}  // namespace armature::gcode
