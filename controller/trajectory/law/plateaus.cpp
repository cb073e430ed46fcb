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

// The first one of those with the same speed.
std::size_t Plateaus::Window::fastest(const TimeTable& table) const noexcept {
  std::size_t best = from;
  for (std::size_t i = from; i <= to; ++i) {
    if (table[i].speed > table[best].speed) best = i;
  }
  return best;
}

std::size_t Plateaus::Window::slowest(const TimeTable& table) const noexcept {
  std::size_t best = from;
  for (std::size_t i = from; i <= to; ++i) {
    if (table[i].speed < table[best].speed) best = i;
  }
  return best;
}

void Plateaus::find(const TimeTable& table, const TableRun& motion, double tau_s, const SpeedLaw& law,
                    const TimeTable::Point* joint) noexcept {
  count_ = 0;
  const std::size_t first = motion.first, last = motion.last;
  const Run run{table, first, last, tau_s, joint};
  // u(t) - u(t - tau) changes at each point and tau after it. So it is looked at over the windows that end, or begin,
  // immediately after a point.
  const double window_s = kWindow * tau_s;
  std::size_t begin = first, end = first;  // the first point inside of the one, the last inside of the other
  for (std::size_t i = first; i <= last; ++i) {
    const double t_s = table[i].t_s;
    while (table[begin].t_s <= t_s - window_s) ++begin;
    while (end < last && table[end + 1].t_s <= t_s + window_s) ++end;
    const double by_change = law.limits(law.point_at(table[i].s)).jerk.by_change;
    const double change_before = run.accel(i) - (begin > first ? run.accel(begin - 1) : 0.0);
    const double change_after = run.accel(end) - run.accel(i);
    if (!run.executed(t_s)) flatten(run, {begin, i, change_before, by_change});
    if (!run.executed(t_s + window_s)) flatten(run, {i, end, change_after, by_change});
  }
}

// Cuts the peak, or fills the valley, of a window whose acceleration changes too much.
void Plateaus::flatten(const Run& run, const Window& window) noexcept {
  const double change = window.change;
  // A slow place must stay slow: it may have limits across the path. The mean over tau is faster by change tau / 8.
  const double faster = 0.125 * change * run.tau_s;
  const bool sharp = std::fabs(change) * window.by_change > kSharpness * run.tau_s;
  if ((!sharp && !(faster > 0.0)) || window.from > window.to) return;
  const bool brakes = change < 0.0;
  const std::size_t at = brakes ? window.fastest(run.table) : window.slowest(run.table);
  if (at == run.first || at == run.last) return;
  if (!sharp && faster < kHardlyFaster * run.table[at].speed) return;
  const double before = run.accel(at - 1), after = run.accel(at);
  if (brakes) {
    if (before >= 0.0 && after <= 0.0) cut(run, at);
  } else if (before <= 0.0 && after >= 0.0) {
    fill(run, at);
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

// A point of the law that is faster than those beside it, and the levels at which it can be cut.
class Plateaus::Peak {
 public:
  Peak(const Run& run, std::size_t at) noexcept : run_{run}, table_{run.table}, at_{at} {}

  [[nodiscard]] double speed() const noexcept { return table_[at_].speed; }
  // Where the law crosses a level, seen from the peak.
  [[nodiscard]] Crossing before(double level) const noexcept { return crossing(level, true); }
  [[nodiscard]] Crossing after(double level) const noexcept { return crossing(level, false); }

  // The highest level at which a cut lasts for tau.
  [[nodiscard]] double highest_cut() const noexcept {
    const Levels tried = try_levels();
    double low = 0.0, high = speed();
    for (int i = 0; i < kLevelHalvings; ++i) {
      const double level = 0.5 * (low + high);
      (level <= tried.enough || (level < tried.too_high && lasts(level)) ? low : high) = level;
    }
    return low;
  }

 private:
  struct Levels {
    double enough, too_high;  // a cut lasts, or does not
  };

  // A crossing of a low level is far away. So first some levels that are crossed close to the peak.
  [[nodiscard]] Levels try_levels() const noexcept {
    Levels tried{0.0, speed()};
    const std::size_t farthest = std::max(at_ - run_.first, run_.last - at_);
    for (std::size_t far = 1; far < farthest; far *= 2) {
      const double level = level_within(far);
      (lasts(level) ? tried.enough : tried.too_high) = level;
      if (tried.enough > 0.0) break;
    }
    return tried;
  }

  // The least level that is crossed within `far` points on both sides.
  [[nodiscard]] double level_within(std::size_t far) const noexcept {
    double left = speed(), right = left;
    for (std::size_t i = 1; i <= far; ++i) {
      if (run_.first + i <= at_) left = std::min(left, table_[at_ - i].speed);
      if (at_ + i <= run_.last) right = std::min(right, table_[at_ + i].speed);
    }
    return std::max(left, right);
  }

  [[nodiscard]] bool lasts(double level) const noexcept {
    return after(level).s - before(level).s >= level * run_.tau_s;
  }

  [[nodiscard]] Crossing crossing(double level, bool before) const noexcept {
    std::size_t inside = at_;
    const auto outside = [&] { return before ? inside - 1 : inside + 1; };
    while (inside != (before ? run_.first : run_.last) && table_[outside()].speed > level) inside = outside();
    if (inside == (before ? run_.first : run_.last)) return {table_[inside].s, table_[inside].t_s};
    const TimeTable::Point &a = table_[inside], &b = table_[outside()];
    const double after_s = (a.speed - level) / (a.speed - b.speed) * (b.t_s - a.t_s);
    return {a.s + 0.5 * (a.speed + level) * after_s, a.t_s + after_s};
  }

  const Run& run_;
  const TimeTable& table_;
  std::size_t at_;
};

void Plateaus::cut(const Run& run, std::size_t at) noexcept {
  const TimeTable& table = run.table;
  const Peak peak{run, at};
  if (run.joint != nullptr && !(peak.speed() > run.joint->speed)) return;  // nothing to cut
  double level = peak.highest_cut();
  Crossing from = peak.before(level), to = peak.after(level);
  if (run.joint != nullptr && from.s < run.joint->s && level < run.joint->speed) {
    level = run.joint->speed;
    from = {run.joint->s, run.joint->t_s};
    to = peak.after(level);
  }
  // A peak beside a higher one: the plateau leads to that.
  const double too_long = to.s - from.s - level * run.tau_s;
  if (too_long > 0.0) {
    const bool before = table[at].s - from.s > to.s - table[at].s;
    Crossing& far = before ? from : to;
    far.s += before ? too_long : -too_long;
    far.t_s = table.time_at(far.s);
  }
  add(run, {.from = from.s,
            .to = to.s,
            .square = level * level,
            .longer_s = std::max(0.0, run.tau_s - (to.t_s - from.t_s))});
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
