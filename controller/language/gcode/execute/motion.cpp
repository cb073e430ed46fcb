#include "controller/language/gcode/execute/motion.hpp"

#include <algorithm>
#include <cmath>

#include "controller/base/angle_units.hpp"
#include "controller/base/math.hpp"
#include "controller/language/gcode/reader/operations.hpp"

namespace armature::gcode {
namespace {

constexpr double kArcTolerance_mm = 2.0 * 0.01 * 1.4142135623730951;
constexpr double kArcToleranceOfInches = 2.0 * 0.001 * 1.4142135623730951;
constexpr std::array<char, 3> kCentreLetterOf{'i', 'j', 'k'};
constexpr double kMinRate = 0.1;  // of inverse time feed, in units per minute
constexpr int kMaxTurns = 100;

double linear_distance(const Axes6& a, const Axes6& b) noexcept {
  return math::hypot(math::hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}
double rotary_distance(const Axes6& a, const Axes6& b) noexcept {
  return math::hypot(math::hypot(a[3] - b[3], a[4] - b[4]), a[5] - b[5]);
}

}  // namespace

Failure Motion::set_polar(Block& block) const noexcept {
  Words& words = block.words;
  const bool angle_given = words.has('^');
  if (!words.has('@') && !angle_given) return std::nullopt;
  for (const char letter : {'x', 'y'}) {
    if (words.has(letter)) return error_of(ErrorCode::kPolarWithAxis, letter);
  }
  const CodeInfo* distance = block.code(Group::kDistance);
  const bool incremental = distance != nullptr ? distance->tenths == 910 : modes_.active().incremental;
  const double x = coordinates_.place()[0] / modes_.unit_mm();
  const double y = coordinates_.place()[1] / modes_.unit_mm();
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

Failure Motion::move(const Block& block) noexcept {
  if (block.is(Group::kMotion, 800)) active_ = nullptr;
  const CodeInfo* motion = block.motion;
  if (motion == nullptr) return std::nullopt;
  Failure failure;
  if (is_cycle(*motion)) {
    failure = cycles_.begin(block, active_);
  } else if (motion->tenths >= 20) {
    failure = move_arc(block);
  } else {
    failure = move_straight(block);
  }
  active_ = motion;
  return failure;
}

void Motion::go_home(const Block& block, int parameter) noexcept {
  traverse(coordinates_.target(block.words));
  const Axes6 home = coordinates_.home(parameter);
  if (!block.words.any_axis()) return traverse(home);
  Axes6 end = coordinates_.place();
  for (std::size_t i = 0; i < kAxes; ++i) {
    if (block.words.has(kAxisLetters[i])) end[i] = home[i];
  }
  traverse(end);
}

Failure Motion::move_straight(const Block& block) noexcept {
  Axes6 end = coordinates_.target(block.words);
  if (block.is(Group::kOnce, 530)) {
    if (modes_.active().incremental) return error_of(ErrorCode::kG53Incremental, *block.code(Group::kOnce));
    end = coordinates_.machine_target(block.words);
  }
  if (block.motion->tenths == 0) {
    traverse(end);
    return std::nullopt;
  }
  const Axes6& place = coordinates_.place();
  if (const Failure failure = apply_feed(block, linear_distance(place, end), rotary_distance(place, end))) {
    return failure;
  }
  coordinates_.move_to(end);
  calls_.emit(StraightFeed{end});
  return std::nullopt;
}

Failure Motion::move_arc(const Block& block) noexcept {
  const Words& words = block.words;
  const PlaneAxes axes = axes_of(modes_.active().plane);
  const bool clockwise = block.motion->tenths == 20;
  const Axes6& place = coordinates_.place();
  const Axes6 end = coordinates_.target(words);
  const PlanePoint from{place[axes.first], place[axes.second]};
  const PlanePoint to{end[axes.first], end[axes.second]};
  int turns = 1;
  PlanePoint centre;
  if (words.has(kCentreLetterOf[axes.normal])) return error_of(ErrorCode::kArcWrongOffset, *block.motion);
  if (words.has('p')) {
    if (const Failure failure = read_whole(words, 'p', 1, kMaxTurns, turns)) return failure;
  }
  if (const Failure failure = find_centre(block, from, to, centre)) return failure;
  const double length =
      math::hypot(arc_length(from, to, centre, clockwise, turns), end[axes.normal] - place[axes.normal]);
  if (const Failure failure = apply_feed(block, length, 0.0)) return failure;
  coordinates_.move_to(end);
  calls_.emit(ArcFeed{.first_end = to.first,
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

Failure Motion::find_centre(const Block& block, PlanePoint from, PlanePoint to, PlanePoint& centre) const noexcept {
  const Words& words = block.words;
  const CodeInfo& code = *block.motion;
  const PlaneAxes axes = axes_of(modes_.active().plane);
  const double unit_mm = modes_.unit_mm();
  const double tolerance_mm = modes_.active().inches ? kArcToleranceOfInches * kMmPerInch : kArcTolerance_mm;
  const char first_letter = kCentreLetterOf[axes.first];
  const char second_letter = kCentreLetterOf[axes.second];
  const bool centre_given = words.has(first_letter) || words.has(second_letter);
  if (words.has('r')) {
    if (centre_given) return error_of(ErrorCode::kWordNotUsed, 'r');
    if (!words.has(kAxisLetters[axes.first]) && !words.has(kAxisLetters[axes.second])) {
      return error_of(ErrorCode::kArcEndMissing, code);
    }
    const ArcCentre found = centre_from_radius(from, to, words.get('r') * unit_mm, code.tenths == 20, tolerance_mm);
    if (const auto* problem = std::get_if<ErrorCode>(&found)) return error_of(*problem, code);
    centre = *std::get_if<PlanePoint>(&found);
    return std::nullopt;
  }
  if (!centre_given) return error_of(ErrorCode::kArcWithoutCentre, code);
  centre = {words.get(first_letter) * unit_mm, words.get(second_letter) * unit_mm};
  if (!modes_.active().absolute_centres) {
    centre.first += from.first;
    centre.second += from.second;
  } else if (!words.has(first_letter) || !words.has(second_letter)) {
    return error_of(ErrorCode::kArcCentreMissing, code);
  }
  if (const auto problem = check_centre(from, to, centre, tolerance_mm)) return error_of(*problem, code);
  return std::nullopt;
}

Failure Motion::apply_feed(const Block& block, double length_mm, double angle_deg) noexcept {
  const Modes::Values& modes = modes_.active();
  if (!modes.inverse_time) {
    if (modes.feed > 0.0) return std::nullopt;
    return error_of(ErrorCode::kFeedRateZero, *block.motion);
  }
  if (!block.words.has('f') || modes.feed <= 0.0) return error_of(ErrorCode::kFeedRateMissing, *block.motion);
  const double unit_mm = modes_.unit_mm();
  const double number = std::max(kMinRate, modes.feed * (length_mm > 0.0 ? length_mm / unit_mm : angle_deg));
  calls_.emit(SetFeedRate{.mm_min = number * unit_mm, .number = number});
  return std::nullopt;
}

void Motion::traverse(const Axes6& end) noexcept {
  coordinates_.move_to(end);
  calls_.emit(StraightTraverse{end});
}

}  // namespace armature::gcode
