#include "controller/language/gcode/execute/overrides.hpp"

namespace armature::gcode {

std::optional<double> Overrides::value_of(std::string_view name) const noexcept {
  return find_value(name, {{"_feed_override", flag(is_on(Kind::kFeed))},
                           {"_speed_override", flag(is_on(Kind::kSpeed))},
                           {"_adaptive_feed", flag(is_on(Kind::kAdaptiveFeed))},
                           {"_feed_hold", flag(is_on(Kind::kFeedHold))}});
}

void Overrides::end_program() noexcept {
  if (!is_on(Kind::kFeed)) turn(Kind::kFeed, true);
}

Failure Overrides::set(const Block& block) noexcept {
  const CodeInfo* code = block.code(Group::kOverride);
  if (code == nullptr) return std::nullopt;
  if (code->tenths < 500) {
    turn(Kind::kFeed, code->tenths == 480);
    turn(Kind::kSpeed, code->tenths == 480);
    return std::nullopt;
  }
  if (block.words.get('p') < 0.0) return error_of(ErrorCode::kWordNegative, 'p');
  turn(static_cast<Kind>((code->tenths - 500) / 10), block.words.get_or('p', 1.0) != 0.0);
  return std::nullopt;
}

void Overrides::restore(const Values& to) noexcept {
  for (const Kind kind : {Kind::kFeed, Kind::kSpeed, Kind::kFeedHold}) {
    const bool on = to[static_cast<std::size_t>(kind)];
    if (is_on(kind) != on) turn(kind, on);
  }
}

void Overrides::turn(Kind kind, bool on) noexcept {
  active_[static_cast<std::size_t>(kind)] = on;
  calls_.emit(EnableOverride{.kind = kind, .on = on});
}

}  // namespace armature::gcode
