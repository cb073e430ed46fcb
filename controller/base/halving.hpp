// Where a function changes its sign: the result of a bisection, bit for bit, in a third of the evaluations.
#pragma once

#include <cmath>
#include <cstdint>

namespace armature {

// The ends between which a function changes its sign, in any order of their size.
struct SignChange {
  double inside = 0.0;   // the function is <= 0
  double outside = 0.0;  // it is > 0
};

struct EndValues {
  double inside = 0.0, outside = 0.0;
};

namespace halving_detail {

// Ends that are at most twice `least` apart, by a secant that keeps both (the rule of Anderson and Björck).
template <class Value>
[[nodiscard]] SignChange narrowed(SignChange near, EndValues at, double least, Value value) noexcept {
  constexpr int kMostSteps = 24, kHalveEvery = 6;
  // Of the value at the end that stays, when the other end moves again.
  const auto weight = [](double found, double before) {
    const double left = 1.0 - found / before;
    return left > 0.0 ? left : 0.5;
  };
  int same_side = 0;  // > 0: the inner end has moved last, < 0: the outer one
  for (int i = 0; i < kMostSteps; ++i) {
    const double way = near.outside - near.inside;
    if (!(way > 2.0 * least)) break;
    const double secant = i % kHalveEvery == kHalveEvery - 1 ? 0.5 * way : way * (at.inside / (at.inside - at.outside));
    const double step = secant < least ? least : secant > way - least ? way - least : secant;
    const double middle = near.inside + step, found = value(middle);
    if (found <= 0.0) {
      if (same_side > 0) at.outside *= weight(found, at.inside);
      near.inside = middle;
      at.inside = found;
      same_side = 1;
    } else {
      if (same_side < 0) at.inside *= weight(found, at.outside);
      near.outside = middle;
      at.outside = found;
      same_side = -1;
    }
  }
  return near;
}

}  // namespace halving_detail

// What so many bisections lead to if value() changes its sign once between the ends. Secants find the place first, to
// two of the last intervals; the halvings then evaluate only there. If the sign changes more than once, one of the
// changes is found.
template <int kHalvings, class Value>
[[nodiscard]] SignChange halved(SignChange ends, const EndValues& at, Value value) noexcept {
  constexpr double kLeastShare = 1.0 / static_cast<double>(std::uint64_t{1} << kHalvings);
  // Seen in a mirror if need be, so that inside < outside.
  const double direction = ends.outside > ends.inside ? 1.0 : -1.0;
  const auto mirrored = [&](double x) { return value(direction * x); };
  ends = {.inside = direction * ends.inside, .outside = direction * ends.outside};
  // Known: from the end inside up to `near.inside` it is <= 0, from `near.outside` on > 0.
  SignChange near = ends;
  if (at.outside > 0.0) {
    near = halving_detail::narrowed(ends, at, kLeastShare * (ends.outside - ends.inside), mirrored);
  } else {
    near.inside = ends.outside;
  }
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (ends.inside + ends.outside);
    const bool known = middle <= near.inside || middle >= near.outside;
    const bool inside = known ? middle <= near.inside : mirrored(middle) <= 0.0;
    (inside ? ends.inside : ends.outside) = middle;
  }
  return {.inside = direction * ends.inside, .outside = direction * ends.outside};
}

}  // namespace armature
