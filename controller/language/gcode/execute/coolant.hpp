// Mist and flood: M7, M8 and M9.
#pragma once

#include <optional>
#include <string_view>

#include "controller/language/gcode/canon/line_calls.hpp"
#include "controller/language/gcode/reader/block.hpp"

namespace armature::gcode {

class Coolant {
 public:
  struct Values {
    bool mist = false;
    bool flood = false;
  };

  explicit Coolant(LineCalls& calls) noexcept : calls_(calls) {}

  [[nodiscard]] const Values& active() const noexcept { return active_; }
  [[nodiscard]] std::optional<double> value_of(std::string_view name) const noexcept {
    return find_value(name, {{"_mist", flag(active_.mist)}, {"_flood", flag(active_.flood)}});
  }

  void begin_program() noexcept { active_ = {}; }
  void end_program() noexcept {
    if (active_.mist) calls_.emit(Mist{});
    if (active_.flood) calls_.emit(Flood{});
    active_ = {};
  }

  void set(const Block& block) noexcept {
    const CodeInfo* code = block.code(Group::kCoolant);
    if (code == nullptr) return;
    if (code->tenths == 70) {
      switch_on({.mist = true});
    } else if (code->tenths == 80) {
      switch_on({.flood = true});
    } else {
      switch_off();
    }
  }

  // As rs274 does: one that is on goes off only with the other one.
  void restore(const Values& to) noexcept {
    if (to.mist || to.flood) {
      switch_on({.mist = to.mist && !active_.mist, .flood = to.flood && !active_.flood});
    } else if (active_.mist || active_.flood) {
      switch_off();
    }
  }

 private:
  void switch_on(const Values& which) noexcept {
    if (which.mist) calls_.emit(Mist{true});
    if (which.flood) calls_.emit(Flood{true});
    active_ = {.mist = active_.mist || which.mist, .flood = active_.flood || which.flood};
  }
  void switch_off() noexcept {
    active_ = {};
    calls_.emit(Mist{});
    calls_.emit(Flood{});
  }

  LineCalls& calls_;
  Values active_{};
};

}  // namespace armature::gcode
