#include "controller/trajectory/law/moving_average.hpp"

#include <algorithm>

#include "controller/core/timebase.hpp"

namespace armature {
namespace {

constexpr double kSameTime_s = 1e-9;

// A motion between two stops, evaluated at increasing times.
class Walk {
 public:
  Walk(const TimeTable& table, std::size_t first, std::size_t last) : table_{table}, at_{first}, last_{last} {}

  struct State {
    double s, speed;
  };
  State at(double t_s) {
    while (at_ < last_ && table_[at_ + 1].t_s <= t_s) ++at_;
    const TimeTable::Point& a = table_[at_];
    if (at_ == last_ || t_s <= a.t_s) return {a.s, a.speed};
    const double after_s = t_s - a.t_s, accel = table_.accel(at_);
    return {a.s + (a.speed + 0.5 * accel * after_s) * after_s, a.speed + accel * after_s};
  }

 private:
  const TimeTable& table_;
  std::size_t at_, last_;
};

}  // namespace

void moving_average(const TimeTable& law, std::span<const Ticks> tau, TimeTable& result) noexcept {
  result.clear();
  Ticks longer{};
  std::size_t run = 0;
  for (std::size_t first = 0; first + 1 < law.size(); ++run) {
    std::size_t last = first + 1;
    while (law[last].speed > 0.0) ++last;
    const double start_s = seconds(longer);
    if (run >= tau.size() || tau[run] == Ticks{}) {
      for (std::size_t i = first; i <= last; ++i) {
        result.append({.t_s = law[i].t_s + start_s, .s = law[i].s, .speed = law[i].speed});
      }
      first = last;
      continue;
    }
    const double tau_s = seconds(tau[run]), end_s = law[last].t_s + tau_s;
    Walk front{law, first, last}, back{law, first, last};
    TimeTable::Point before{.t_s = law[first].t_s, .s = law[first].s};
    double accel_before = 0.0, rest = 0.0;  // `rest`: what the rounding of `before.s` left out
    std::size_t i = first, k = first;
    while (before.t_s < end_s) {
      // The next of the points at t and t + tau.
      double t_s = end_s;
      while (i <= last && law[i].t_s <= before.t_s + kSameTime_s) ++i;
      while (k <= last && law[k].t_s + tau_s <= before.t_s + kSameTime_s) ++k;
      if (i <= last) t_s = std::min(t_s, law[i].t_s);
      if (k <= last) t_s = std::min(t_s, law[k].t_s + tau_s);
      const Walk::State now = front.at(t_s), past = back.at(t_s - tau_s);
      TimeTable::Point next{.t_s = t_s, .speed = (now.s - past.s) / tau_s};
      const double accel = (now.speed - past.speed) / tau_s, step_s = t_s - before.t_s;
      before.jerk = (accel - accel_before) / step_s;
      const double covered = rest + step_s * (0.5 * (before.speed + next.speed) - before.jerk * step_s * step_s / 12.0);
      next.s = before.s + covered;
      rest = covered - (next.s - before.s);
      result.append({.t_s = before.t_s + start_s, .s = before.s, .speed = before.speed, .jerk = before.jerk});
      before = next;
      accel_before = accel;
      if (end_s - t_s <= kSameTime_s) break;
    }
    longer = longer + tau[run];
    result.append({.t_s = law[last].t_s + seconds(longer), .s = law[last].s});
    first = last;
  }
  result.end(law.duration() + longer);
}

}  // namespace armature
