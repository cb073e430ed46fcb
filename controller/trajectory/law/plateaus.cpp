#include "controller/trajectory/law/plateaus.hpp"

#include <algorithm>
#include <cmath>

namespace armature {
namespace {

constexpr double kWindow = 1.0 - 1e-6;  // of tau, so that a plateau of tau is enough
constexpr double kSharpness = 1.005;    // of a change of the acceleration
constexpr double kHardlyFaster = 0.1;   // share
constexpr double kSameLevel = 1e-6;     // share
constexpr double kFilled = 1e-6;        // share of a plateau that may be missing
constexpr double kCloseBehind = 1e-3;   // share of a plateau
constexpr int kLevelHalvings = 50;

// The point or stop after the crossing of a speed, seen from a peak, and the crossing.
struct Crossing {
  double s, t_s;
};

}  // namespace

void Plateaus::find(const TimeTable& table, const TableRun& motion, double tau_s, const SpeedLaw& law,
                    const TimeTable::Point* joint) noexcept {
  count_ = 0;
  const std::size_t first = motion.first, last = motion.last;
  const Run run{table, first, last, tau_s, joint};
  const auto accel = [&](std::size_t piece) { return piece >= first && piece < last ? table.accel(piece) : 0.0; };
  // u(t) - u(t - tau) changes at each point and tau after it. So it is looked at over the windows that end, or begin,
  // immediately after a point.
  const double window_s = kWindow * tau_s;
  std::size_t begin = first, end = first;  // the first point inside of the one, the last inside of the other
  for (std::size_t i = first; i <= last; ++i) {
    const double t_s = table[i].t_s, least = kSharpness * tau_s;
    while (table[begin].t_s <= t_s - window_s) ++begin;
    while (end < last && table[end + 1].t_s <= t_s + window_s) ++end;
    const double by_change = law.limits(law.point_at(table[i].s)).jerk.by_change;
    const double change_before = accel(i) - (begin > first ? accel(begin - 1) : 0.0);
    const double change_after = accel(end) - accel(i);
    const auto sharpest = [&](std::size_t from, std::size_t to, double change) {
      // A slow place must stay slow: it may have limits across the path. The mean over tau is faster by change tau / 8.
      const double faster = 0.125 * change * tau_s;
      const bool sharp = std::fabs(change) * by_change > least;
      if ((!sharp && !(faster > 0.0)) || from > to) return;
      std::size_t best = from;
      for (std::size_t k = from; k <= to; ++k) {
        if (change < 0.0 ? table[k].speed > table[best].speed : table[k].speed < table[best].speed) best = k;
      }
      if (best == first || best == last) return;
      if (!sharp && faster < kHardlyFaster * table[best].speed) return;
      const double before = accel(best - 1), after = accel(best);
      const bool turns = change < 0.0 ? before >= 0.0 && after <= 0.0 : before <= 0.0 && after >= 0.0;
      if (!turns) return;
      if (change < 0.0) {
        cut(run, best);
      } else {
        fill(run, best);
      }
    };
    const auto executed = [&](double until_s) { return joint != nullptr && until_s <= joint->t_s; };
    if (!executed(t_s)) sharpest(begin, i, change_before);
    if (!executed(t_s + window_s)) sharpest(i, end, change_after);
  }
}

void Plateaus::add(const Run& run, Plateau plateau) noexcept {
  if (run.joint != nullptr && plateau.from <= run.joint->s + kCloseBehind * (plateau.to - plateau.from)) {
    plateau.from = run.joint->s;
    plateau.square = std::max(plateau.square, run.joint->speed * run.joint->speed);
    if (!(plateau.to > plateau.from)) return;
  }
  for (std::size_t i = 0; i < count_; ++i) {
    // The same peak from another window.
    if (found_[i].from == plateau.from && found_[i].to == plateau.to) return;
  }
  if (count_ < kMax) found_[count_++] = plateau;
}

void Plateaus::cut(const Run& run, std::size_t peak) noexcept {
  const TimeTable& table = run.table;
  const auto crossing = [&](double level, bool before) {
    std::size_t inside = peak;
    const auto outside = [&] { return before ? inside - 1 : inside + 1; };
    while (inside != (before ? run.first : run.last) && table[outside()].speed > level) inside = outside();
    if (inside == (before ? run.first : run.last)) return Crossing{table[inside].s, table[inside].t_s};
    const TimeTable::Point &a = table[inside], &b = table[outside()];
    const double after_s = (a.speed - level) / (a.speed - b.speed) * (b.t_s - a.t_s);
    return Crossing{a.s + 0.5 * (a.speed + level) * after_s, a.t_s + after_s};
  };
  if (run.joint != nullptr && !(table[peak].speed > run.joint->speed)) return;  // nothing to cut
  const auto lasts = [&](double level) {
    return crossing(level, false).s - crossing(level, true).s >= level * run.tau_s;
  };
  // A crossing of a low level is far away. So first some levels that are crossed close to the peak.
  double enough = 0.0, too_high = table[peak].speed;
  const std::size_t farthest = std::max(peak - run.first, run.last - peak);
  for (std::size_t far = 1; far < farthest; far *= 2) {
    double left = table[peak].speed, right = left;
    for (std::size_t i = 1; i <= far; ++i) {
      if (run.first + i <= peak) left = std::min(left, table[peak - i].speed);
      if (peak + i <= run.last) right = std::min(right, table[peak + i].speed);
    }
    const double level = std::max(left, right);
    (lasts(level) ? enough : too_high) = level;
    if (enough > 0.0) break;
  }
  double low = 0.0, high = table[peak].speed;
  for (int i = 0; i < kLevelHalvings; ++i) {
    const double level = 0.5 * (low + high);
    (level <= enough || (level < too_high && lasts(level)) ? low : high) = level;
  }
  Crossing from = crossing(low, true), to = crossing(low, false);
  if (run.joint != nullptr && from.s < run.joint->s && low < run.joint->speed) {
    low = run.joint->speed;
    from = {run.joint->s, run.joint->t_s};
    to = crossing(low, false);
  }
  // A peak beside a higher one: the plateau leads to that.
  const double too_long = to.s - from.s - low * run.tau_s;
  if (too_long > 0.0) {
    const bool before = table[peak].s - from.s > to.s - table[peak].s;
    Crossing& far = before ? from : to;
    far.s += before ? too_long : -too_long;
    far.t_s = table.time_at(far.s);
  }
  add(run,
      {.from = from.s, .to = to.s, .square = low * low, .longer_s = std::max(0.0, run.tau_s - (to.t_s - from.t_s))});
}

void Plateaus::fill(const Run& run, std::size_t valley) noexcept {
  const TimeTable& table = run.table;
  const double speed = table[valley].speed, same = speed * (1.0 + kSameLevel);
  std::size_t left = valley, right = valley;
  while (left > run.first && table[left - 1].speed <= same && table[left - 1].speed > 0.0) --left;
  while (right < run.last && table[right + 1].speed <= same && table[right + 1].speed > 0.0) ++right;
  const double needed = 0.5 * (speed * run.tau_s - (table[right].s - table[left].s));
  if (needed <= kFilled * speed * run.tau_s) return;
  double from = std::max(table[left].s - needed, table[run.first].s), to = table[right].s + needed;
  if (run.joint != nullptr) {
    // What is missing before the joint follows behind it.
    const double earliest = std::min(table[left].s, run.joint->s);
    to += std::max(0.0, earliest - from);
    from = std::max(from, earliest);
  }
  to = std::min(to, table[run.last].s);
  add(run, {.from = from,
            .to = to,
            .square = speed * speed,
            .longer_s = std::max(0.0, run.tau_s - (table.time_at(to) - table.time_at(from)))});
}

}  // namespace armature
