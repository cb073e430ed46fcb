#include "controller/language/gcode/execute/cycles.hpp"

#include <algorithm>

namespace armature::gcode {
namespace {

constexpr double kPeckClearance_mm = 0.254;  // above the bottom of the peck before
constexpr double kMaxPecks = 10000.0;
constexpr int kMaxRepeats = 1'000'000;

// Kinds of cycles.
bool is_tap(const CodeInfo& cycle) noexcept {
  return cycle.tenths == 740 || cycle.tenths == 840;
}
bool has_pecks(const CodeInfo& cycle) noexcept {
  return cycle.tenths == 730 || cycle.tenths == 830;
}
bool dwells(const CodeInfo& cycle) noexcept {
  return cycle.tenths == 820 || is_tap(cycle);
}

}  // namespace

void Cycles::begin_program() noexcept {
  drill_.abort();
  memory_ = {};
}

Failure Cycles::begin(const Block& block, const CodeInfo* active) noexcept {
  const Words& words = block.words;
  const CodeInfo& code = *block.motion;
  const Modes::Values& modes = modes_.active();
  int repeats = 1;
  if (modes.inverse_time) return error_of(ErrorCode::kCycleInverseTime, code);
  if (modes.feed <= 0.0) return error_of(ErrorCode::kFeedRateZero, code);
  if (words.has('a') || words.has('b') || words.has('c')) return error_of(ErrorCode::kCycleRotaryAxis, code);
  if (words.has('l')) {
    if (const Failure failure = read_whole(words, 'l', 1, kMaxRepeats, repeats)) return failure;
  }
  if (const Failure failure = remember(block, active == &code)) return failure;
  if (active == nullptr || !is_cycle(*active)) {
    memory_.start_height = coordinates_.place()[axes_of(modes.plane).normal];
  }
  const double clearance = memory_.clearance + (modes.incremental ? memory_.start_height : 0.0);
  const double bottom = memory_.bottom + (modes.incremental ? clearance : 0.0);
  if (clearance < bottom) return error_of(ErrorCode::kCycleDepth, code);
  if (has_pecks(code) && (clearance - bottom) / memory_.peck > kMaxPecks) return error_of(ErrorCode::kWordRange, 'q');

  DrillRequest holes = holes_of(block, clearance, bottom);
  holes.repeats = repeats;
  drill_.begin(holes);
  coordinates_.move_to(drill_.place());
  return std::nullopt;
}

void Cycles::step() noexcept {
  drill_.step();
  coordinates_.move_to(drill_.place());
}

Failure Cycles::remember(const Block& block, bool continues) noexcept {
  const CodeInfo& code = *block.motion;
  if (const Failure failure = remember_heights(block, continues)) return failure;
  if (is_tap(code) && spindle_.active().direction != (code.tenths == 840 ? 1 : -1)) {
    return error_of(ErrorCode::kTapSpindle, code);
  }
  if (dwells(code)) return remember_dwell(block, continues);
  if (has_pecks(code)) return remember_peck(block.words, continues);
  return std::nullopt;
}

// R and the bottom.
Failure Cycles::remember_heights(const Block& block, bool continues) noexcept {
  const Words& words = block.words;
  const double unit_mm = modes_.unit_mm();
  const char bottom = kAxisLetters[axes_of(modes_.active().plane).normal];
  if (!continues && !words.has('r')) return error_of(ErrorCode::kCycleClearanceMissing, *block.motion);
  if (!continues && !words.has(bottom)) return error_of(ErrorCode::kCycleDepthMissing, *block.motion);
  if (words.has('r')) memory_.clearance = words.get('r') * unit_mm;
  if (words.has(bottom)) memory_.bottom = words.get(bottom) * unit_mm;
  return std::nullopt;
}

// P.
Failure Cycles::remember_dwell(const Block& block, bool continues) noexcept {
  const Words& words = block.words;
  if (!is_tap(*block.motion) && !continues && !words.has('p')) return error_of(ErrorCode::kWordMissing, 'p');
  if (words.get('p') < 0.0) return error_of(ErrorCode::kWordNegative, 'p');
  if (words.has('p')) memory_.dwell_s = words.get('p');
  return std::nullopt;
}

// Q.
Failure Cycles::remember_peck(const Words& words, bool continues) noexcept {
  if (!continues && !words.has('q')) return error_of(ErrorCode::kWordMissing, 'q');
  if (!words.has('q')) return std::nullopt;
  if (words.get('q') <= 0.0) return error_of(ErrorCode::kWordRange, 'q');
  memory_.peck = words.get('q') * modes_.unit_mm();
  return std::nullopt;
}

DrillRequest Cycles::holes_of(const Block& block, double clearance, double bottom) const noexcept {
  const CodeInfo& code = *block.motion;
  const Modes::Values& modes = modes_.active();
  const PlaneAxes axes = axes_of(modes.plane);
  const Axes6& place = coordinates_.place();
  const Axes6 end = coordinates_.target(block.words);
  DrillRequest holes{.from = place, .plane = modes.plane, .first = end[axes.first], .second = end[axes.second]};
  if (modes.incremental) {
    holes.first_step = end[axes.first] - place[axes.first];
    holes.second_step = end[axes.second] - place[axes.second];
  }
  holes.clearance = clearance;
  holes.bottom = bottom;
  holes.retract = modes.retract_to_start ? std::max(memory_.start_height, clearance) : clearance;
  holes.approach = modes.retract_to_start ? holes.retract : std::max(place[axes.normal], clearance);
  holes.rise_first = memory_.start_height < clearance;
  if (dwells(code)) holes.dwell_s = memory_.dwell_s;
  if (is_tap(code)) holes.tap = spindle_.active().direction;
  holes.feed_override = overrides_.is_on(Overrides::Kind::kFeed);
  holes.speed_override = overrides_.is_on(Overrides::Kind::kSpeed);
  if (has_pecks(code)) {
    holes.peck = memory_.peck;
    holes.peck_clearance = kPeckClearance_mm;
    holes.breaks_chips = code.tenths == 730;
  }
  holes.control = modes.control;
  holes.naive_cam_mm = modes.naive_cam_mm;
  return holes;
}

}  // namespace armature::gcode
