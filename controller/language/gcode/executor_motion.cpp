// Lines, arcs, cycles and the ways home.
#include <algorithm>
#include <cmath>

#include "controller/base/math.hpp"
#include "controller/language/gcode/arc.hpp"
#include "controller/language/gcode/executor.hpp"
#include "controller/language/gcode/operations.hpp"

namespace armature::gcode {
namespace {

constexpr double kArcTolerance_mm = 2.0 * 0.01 * 1.4142135623730951;
constexpr double kArcToleranceOfInches = 2.0 * 0.001 * 1.4142135623730951;
constexpr std::array<char, 3> kCentreLetterOf{'i', 'j', 'k'};
constexpr double kLeastRate = 0.1;  // of inverse time feed, in units per minute
constexpr int kMostTurns = 100;

double linear_distance(const Axes6& a, const Axes6& b) noexcept {
  return math::hypot(math::hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}
double rotary_distance(const Axes6& a, const Axes6& b) noexcept {
  return math::hypot(math::hypot(a[3] - b[3], a[4] - b[4]), a[5] - b[5]);
}
}  // namespace

Executor::Failure Executor::move(const Block& block) noexcept {
  if (block.is(Group::kMotion, 800)) modes_.motion = nullptr;
  const CodeInfo* motion = block.motion;
  if (motion == nullptr) return std::nullopt;
  Failure failure;
  if (is_cycle(*motion)) {
    failure = begin_cycle(block);
  } else if (motion->tenths >= 20) {
    failure = move_arc(block);
  } else {
    failure = move_straight(block);
  }
  modes_.motion = motion;
  return failure;
}

Executor::Failure Executor::feed_for(double length, double angle, const Words& words) noexcept {
  if (!modes_.inverse_time) {
    if (modes_.feed > 0.0) return std::nullopt;
    return Error{.code = ErrorCode::kFeedRateZero};
  }
  if (!words.has('f') || modes_.feed <= 0.0) return Error{.code = ErrorCode::kFeedRateMissing};
  const double number = std::max(kLeastRate, modes_.feed * (length > 0.0 ? length / unit_mm() : angle));
  emit(SetFeedRate{.mm_min = number * unit_mm(), .number = number});
  return std::nullopt;
}

Executor::Failure Executor::move_straight(const Block& block) noexcept {
  Axes6 end = target(block.words);
  if (block.is(Group::kOnce, 530)) {
    if (modes_.incremental) return error_of(ErrorCode::kG53Incremental, *block.code(Group::kOnce));
    const Axes6 machine = offsets_.machine(place_);
    end = offsets_.place(with_words(block.words, machine));
  }
  if (block.motion->tenths == 0) {
    traverse(end);
    return std::nullopt;
  }
  if (Failure failure = feed_for(linear_distance(place_, end), rotary_distance(place_, end), block.words)) {
    return error_of(failure->code, *block.motion);
  }
  place_ = end;
  emit(StraightFeed{end});
  return std::nullopt;
}

Executor::Failure Executor::move_arc(const Block& block) noexcept {
  const Words& words = block.words;
  const CodeInfo& code = *block.motion;
  const PlaneAxes axes = axes_of(modes_.plane);
  const bool clockwise = code.tenths == 20;
  const double tolerance_mm = modes_.inches ? kArcToleranceOfInches * kMmPerInch : kArcTolerance_mm;
  const Axes6 end = target(words);
  const PlanePoint from{place_[axes.first], place_[axes.second]};
  const PlanePoint to{end[axes.first], end[axes.second]};
  const char first_letter = kCentreLetterOf[axes.first];
  const char second_letter = kCentreLetterOf[axes.second];
  const bool centre_given = words.has(first_letter) || words.has(second_letter);
  PlanePoint centre;
  int turns = 1;

  if (words.has(kCentreLetterOf[axes.normal])) return error_of(ErrorCode::kArcWrongOffset, code);
  if (words.has('p')) {
    if (const Failure failure = whole(words, 'p', 1, kMostTurns, turns)) return failure;
  }
  if (words.has('r')) {
    if (centre_given) return error_of(ErrorCode::kWordNotUsed, 'r');
    if (!words.has(kAxisLetters[axes.first]) && !words.has(kAxisLetters[axes.second])) {
      return error_of(ErrorCode::kArcEndMissing, code);
    }
    const ArcCentre found = centre_from_radius(from, to, words.get('r') * unit_mm(), clockwise, tolerance_mm);
    if (const auto* problem = std::get_if<ErrorCode>(&found)) return error_of(*problem, code);
    centre = *std::get_if<PlanePoint>(&found);
  } else {
    if (!centre_given) return error_of(ErrorCode::kArcWithoutCentre, code);
    centre = {words.get(first_letter) * unit_mm(), words.get(second_letter) * unit_mm()};
    if (!modes_.absolute_centres) {
      centre.first += from.first;
      centre.second += from.second;
    } else if (!words.has(first_letter) || !words.has(second_letter)) {
      return error_of(ErrorCode::kArcCentreMissing, code);
    }
    if (const auto problem = check_centre(from, to, centre, tolerance_mm)) return error_of(*problem, code);
  }
  const double length =
      math::hypot(arc_length(from, to, centre, clockwise, turns), end[axes.normal] - place_[axes.normal]);
  if (Failure failure = feed_for(length, 0.0, words)) return error_of(failure->code, code);
  place_ = end;
  emit(ArcFeed{.first_end = to.first,
               .second_end = to.second,
               .first_axis = centre.first,
               .second_axis = centre.second,
               .rotation = clockwise ? -turns : turns,
               .axis_end = end[axes.normal],
               .a = end[3],
               .b = end[4],
               .c = end[5]});
  return std::nullopt;
}

void Executor::go_home(const Block& block, int parameter) noexcept {
  traverse(target(block.words));
  const Axes6 home = offsets_.place(stored(parameter));
  if (!block.words.any_axis()) return traverse(home);
  Axes6 end = place_;
  for (std::size_t i = 0; i < kAxes; ++i) {
    if (block.words.has(kAxisLetters[i])) end[i] = home[i];
  }
  traverse(end);
}

Executor::Failure Executor::set_polar(Words& words, const Block& block) const noexcept {
  const bool radius_given = words.has('@');
  const bool angle_given = words.has('^');
  if (!radius_given && !angle_given) return std::nullopt;
  for (const char letter : {'x', 'y'}) {
    if (words.has(letter)) return error_of(ErrorCode::kPolarWithAxis, letter);
  }
  const bool incremental =
      block.code(Group::kDistance) != nullptr ? block.is(Group::kDistance, 910) : modes_.incremental;
  const double x = place_[0] / unit_mm();
  const double y = place_[1] / unit_mm();
  if (!angle_given && x == 0.0 && y == 0.0) return error_of(ErrorCode::kPolarAtOrigin, '@');
  double radius = math::hypot(x, y);
  double angle_deg = arc_tangent_deg(y, x);
  if (incremental) {
    radius += words.get('@');
    angle_deg += words.get('^');
  } else {
    radius = words.get_or('@', radius);
    angle_deg = words.get_or('^', angle_deg);
  }
  if (!std::isfinite(radius) || !std::isfinite(angle_deg)) return Error{.code = ErrorCode::kValueTooLarge};
  const math::SinCos turn = math::sin_cos(direction_rad(angle_deg));
  words.set('x', radius * turn.cos - (incremental ? x : 0.0));
  words.set('y', radius * turn.sin - (incremental ? y : 0.0));
  return std::nullopt;
}

Axes6 Executor::with_words(const Words& words, Axes6 axes) const noexcept {
  for (std::size_t i = 0; i < kAxes; ++i) {
    if (words.has(kAxisLetters[i])) axes[i] = words.get(kAxisLetters[i]) * (i < 3 ? unit_mm() : 1.0);
  }
  return axes;
}

Axes6 Executor::target(const Words& words) const noexcept {
  if (!modes_.incremental) return with_words(words, place_);
  Axes6 end = with_words(words, Axes6{});
  for (std::size_t i = 0; i < kAxes; ++i) end[i] += place_[i];
  return end;
}

void Executor::traverse(const Axes6& end) noexcept {
  place_ = end;
  emit(StraightTraverse{end});
}

}  // namespace armature::gcode
