// The start of a drilling cycle.
#include <algorithm>

#include "controller/language/gcode/executor.hpp"

namespace armature::gcode {
namespace {

constexpr double kPeckClearance_mm = 0.254;  // above the bottom of the peck before
constexpr double kMostPecks = 10000.0;
constexpr int kMostRepeats = 1'000'000;

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

// R, bottom, Q and P, from the line or from the line before.
Executor::Failure Executor::remember(const Block& block, bool goes_on) noexcept {
  const Words& words = block.words;
  const CodeInfo& code = *block.motion;
  const char bottom = kAxisLetters[axes_of(modes_.plane).normal];
  if (!goes_on && !words.has('r')) return error_of(ErrorCode::kCycleClearanceMissing, code);
  if (!goes_on && !words.has(bottom)) return error_of(ErrorCode::kCycleDepthMissing, code);
  if (words.has('r')) memory_.clearance = words.get('r') * unit_mm();
  if (words.has(bottom)) memory_.bottom = words.get(bottom) * unit_mm();
  if (is_tap(code) && modes_.spindle != (code.tenths == 840 ? 1 : -1)) return error_of(ErrorCode::kTapSpindle, code);
  if (dwells(code)) {
    if (!is_tap(code) && !goes_on && !words.has('p')) return error_of(ErrorCode::kWordMissing, 'p');
    if (words.get('p') < 0.0) return error_of(ErrorCode::kWordNegative, 'p');
    if (words.has('p')) memory_.dwell_s = words.get('p');
  } else if (has_pecks(code)) {
    if (!goes_on && !words.has('q')) return error_of(ErrorCode::kWordMissing, 'q');
    if (words.has('q') && words.get('q') <= 0.0) return error_of(ErrorCode::kWordRange, 'q');
    if (words.has('q')) memory_.peck = words.get('q') * unit_mm();
  }
  return std::nullopt;
}

Executor::Failure Executor::begin_cycle(const Block& block) noexcept {
  const Words& words = block.words;
  const CodeInfo& code = *block.motion;
  const PlaneAxes axes = axes_of(modes_.plane);
  int repeats = 1;
  if (modes_.inverse_time) return error_of(ErrorCode::kCycleInverseTime, code);
  if (modes_.feed <= 0.0) return error_of(ErrorCode::kFeedRateZero, code);
  if (words.has('a') || words.has('b') || words.has('c')) return error_of(ErrorCode::kCycleRotaryAxis, code);
  if (words.has('l')) {
    if (const Failure failure = whole(words, 'l', 1, kMostRepeats, repeats)) return failure;
  }
  if (const Failure failure = remember(block, modes_.motion == &code)) return failure;
  if (modes_.motion == nullptr || !is_cycle(*modes_.motion)) memory_.start_height = place_[axes.normal];

  const double clearance = memory_.clearance + (modes_.incremental ? memory_.start_height : 0.0);
  const double bottom = memory_.bottom + (modes_.incremental ? clearance : 0.0);
  if (clearance < bottom) return error_of(ErrorCode::kCycleDepth, code);
  if (has_pecks(code) && (clearance - bottom) / memory_.peck > kMostPecks) return error_of(ErrorCode::kWordRange, 'q');

  const bool rises = memory_.start_height < clearance;
  const Axes6 end = target(words);
  DrillRequest request{.from = place_, .plane = modes_.plane, .first = end[axes.first], .second = end[axes.second]};
  if (modes_.incremental) {
    request.first_step = end[axes.first] - place_[axes.first];
    request.second_step = end[axes.second] - place_[axes.second];
  }
  request.clearance = clearance;
  request.bottom = bottom;
  request.retract = modes_.retract_to_start ? std::max(memory_.start_height, clearance) : clearance;
  request.approach = modes_.retract_to_start ? request.retract : std::max(place_[axes.normal], clearance);
  request.rise_first = rises;
  request.repeats = repeats;
  if (dwells(code)) request.dwell_s = memory_.dwell_s;
  if (is_tap(code)) request.tap = modes_.spindle;
  request.feed_override = modes_.overrides[static_cast<std::size_t>(EnableOverride::Kind::kFeed)];
  request.speed_override = modes_.overrides[static_cast<std::size_t>(EnableOverride::Kind::kSpeed)];
  if (has_pecks(code)) {
    request.peck = memory_.peck;
    request.peck_clearance = kPeckClearance_mm;
    request.breaks_chips = code.tenths == 730;
  }
  request.control = modes_.control;
  request.naive_cam_mm = modes_.naive_cam_mm;
  cycle_.begin(request, sink_, line_);
  place_ = cycle_.place();
  return std::nullopt;
}

}  // namespace armature::gcode
