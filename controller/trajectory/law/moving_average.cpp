#include "controller/trajectory/law/moving_average.hpp"

#include <algorithm>

#include "controller/base/timebase.hpp"

namespace armature {
namespace {

constexpr double kSameTime_s = 1e-9;

// A motion between two stops, evaluated at increasing times.
class TableWalk {
 public:
  TableWalk(const TimeTable& table, const TableRun& run) : table_{table}, at_{run.first}, last_{run.last} {}

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

// Appends the average of a motion from `before` on, a point of the average; its times in `result` are later by
// `later_s`.
void append_average(const TimeTable& law, const TableRun& run, double tau_s, TimeTable::Point before, double later_s,
                    TimeTable& result) {
  const double end_s = law[run.last].t_s + tau_s;
  TableWalk front{law, run}, back{law, run};
  double accel_before = (front.at(before.t_s).speed - back.at(before.t_s - tau_s).speed) / tau_s;
  double rest = 0.0;  // what the rounding of `before.s` left out
  std::size_t i = run.first, k = run.first;
  while (before.t_s < end_s) {
    // The next of the points at t and t + tau.
    double t_s = end_s;
    while (i <= run.last && law[i].t_s <= before.t_s + kSameTime_s) ++i;
    while (k <= run.last && law[k].t_s + tau_s <= before.t_s + kSameTime_s) ++k;
    if (i <= run.last) t_s = std::min(t_s, law[i].t_s);
    if (k <= run.last) t_s = std::min(t_s, law[k].t_s + tau_s);
    const TableWalk::State now = front.at(t_s), past = back.at(t_s - tau_s);
    TimeTable::Point next{.t_s = t_s, .speed = (now.s - past.s) / tau_s};
    const double accel = (now.speed - past.speed) / tau_s, step_s = t_s - before.t_s;
    before.jerk = (accel - accel_before) / step_s;
    const double covered = rest + step_s * (0.5 * (before.speed + next.speed) - before.jerk * step_s * step_s / 12.0);
    next.s = before.s + covered;
    rest = covered - (next.s - before.s);
    result.append({.t_s = before.t_s + later_s, .s = before.s, .speed = before.speed, .jerk = before.jerk});
    before = next;
    accel_before = accel;
    if (end_s - t_s <= kSameTime_s) break;
  }
  result.append({.t_s = end_s + later_s, .s = law[run.last].s});
}

TimeTable::Point start_of(const TimeTable& law, const TableRun& run) {
  return {.t_s = law[run.first].t_s, .s = law[run.first].s};
}

}  // namespace

TableRun run_from(const TimeTable& table, std::size_t first) noexcept {
  std::size_t last = first + 1;
  while (table[last].speed > 0.0) ++last;
  while (last + 1 < table.size() && table[last + 1].s == table[last].s) ++last;
  return {first, last};
}

void moving_average(const TimeTable& law, std::span<const Ticks> tau, TimeTable& result) noexcept {
  result.clear();
  Ticks longer{};
  std::size_t index = 0;
  for (TableRun run; run.last + 1 < law.size(); ++index) {
    run = run_from(law, run.last);
    const double later_s = seconds(longer);
    if (index >= tau.size() || tau[index] == Ticks{}) {
      for (std::size_t i = run.first; i <= run.last; ++i) {
        result.append({.t_s = law[i].t_s + later_s, .s = law[i].s, .speed = law[i].speed});
      }
    } else {
      append_average(law, run, seconds(tau[index]), start_of(law, run), later_s, result);
      longer = longer + tau[index];
    }
  }
  result.end(law.duration() + longer);
}

void continue_average(const TimeTable& law, Ticks tau, TimeTable& result) noexcept {
  result.drop_behind_kept();
  TableRun run = run_from(law, 0);
  append_average(law, run, seconds(tau), result.kept_end(), 0.0, result);
  Ticks longer = tau;
  while (run.last + 1 < law.size()) {
    run = run_from(law, run.last);
    append_average(law, run, seconds(tau), start_of(law, run), seconds(longer), result);
    longer = longer + tau;
  }
  result.end(law.duration() + longer);
}

double average_speed(const TimeTable& law, const TableRun& run, Ticks tau, double t_s) noexcept {
  TableWalk front{law, run}, back{law, run};
  return (front.at(t_s).s - back.at(t_s - seconds(tau)).s) / seconds(tau);
}

}  // namespace armature
