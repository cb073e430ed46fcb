#include "controller/trajectory/grid/smooth_law.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/law/moving_average.hpp"
#include "controller/trajectory/profile/synchronise.hpp"

namespace armature {
namespace {

constexpr double kLeastTau_s = 2.0 * kTickSeconds;
// The search: shares of the largest tau, then of the best one.
constexpr double kCoarse = 0.6;
constexpr int kCoarseSteps = 9, kInVain = 1;
constexpr double kFine[]{1.3, 0.78, 1.12, 0.9};
constexpr int kRoundsToTry = 2;  // of added points
constexpr int kSteps = kCoarseSteps + static_cast<int>(std::size(kFine));

// Finding the plateaus of a window costs about as much for so many points as an interval of the law.
constexpr std::size_t kPointsPerInterval = 16;

// Calls visit(index, run) for each motion between two stops, with the points of the table.
template <class Visit>
void each_run(const TimeTable& table, Visit visit) {
  TableRun run;
  for (std::size_t index = 0; run.last + 1 < table.size(); ++index) {
    run = run_from(table, run.last);
    visit(index, run);
  }
}

}  // namespace

bool SmoothLaw::begin(SpeedLaw& law) noexcept {
  extended_ = false;
  find_runs(law);
  const auto is_smooth = [](const Run& run) { return run.smooth; };
  if (std::none_of(runs_.begin(), runs_.begin() + static_cast<std::ptrdiff_t>(count_), is_smooth)) {
    stage_ = Stage::kDone;
    return false;
  }
  stage_ = Stage::kSearch;
  tries_ = tries_without_gain_ = 0;
  plan(law);
  return true;
}

// The run of a point, given that of the point before. At a stop there are two points at the same place: the end of a
// run and the start of the next one.
std::size_t SmoothLaw::run_of(const SpeedLaw& law, std::size_t point, std::size_t run) const noexcept {
  if (point == 0 || run + 1 == count_) return run;
  const double end = runs_[run].to;
  return law.s(point) > end || law.s(point - 1) == end ? run + 1 : run;
}

// Sets tau to the largest that is useful.
void SmoothLaw::find_runs(SpeedLaw& law) noexcept {
  table_.assign(law);
  note_runs();
  std::size_t run = 0;
  for (std::size_t i = 0; i < law.size(); ++i) {
    LawLimits::Jerk& jerk = law.limits(i).jerk;
    jerk.usual_square = law.square(i);
    run = run_of(law, i, run);
    if (!(jerk.by_change > 0.0)) continue;
    runs_[run].smooth = true;
    if (i + 1 == law.size() || !(law.s(i + 1) > law.s(i))) continue;
    const double accel = law.accel(i);
    runs_[run].tau_s = std::max({runs_[run].tau_s, kLeastTau_s, std::fabs(accel) * jerk.by_change});
  }
}

void SmoothLaw::note_runs() noexcept {
  count_ = 0;
  each_run(table_, [this](std::size_t, const TableRun& run) {
    runs_[count_++] = {.from = table_[run.first].s, .to = table_[run.last].s};
  });
}

void SmoothLaw::plan(SpeedLaw& law) noexcept {
  law.free();
  std::size_t run = 0;
  for (std::size_t i = 0; i < law.size(); ++i) {
    run = run_of(law, i, run);
    if (runs_[run].smooth && law.limits(i).jerk.by_change > 0.0) limit_jerk(law.limits(i), runs_[run].tau_s);
  }
  law.begin(stage_ == Stage::kSearch ? kRoundsToTry : SpeedLaw::kMaxRounds);
}

void SmoothLaw::plan_again(SpeedLaw& law) noexcept {
  stage_ = Stage::kShape;
  rounds_ = 0;
  law.begin(extended_ ? kRoundsToTry + 1 : SpeedLaw::kMaxRounds);
}

SmoothLaw::Progress SmoothLaw::work(SpeedLaw& law, std::size_t intervals) noexcept {
  cost_ = static_cast<int>(intervals);
  if (stage_ == Stage::kDone) return Progress::kDone;
  if (law.work(intervals) == SpeedLaw::Progress::kWorking) return Progress::kWorking;
  if (extended_ && !law.starts_as_asked()) {
    if (!law.ease_start()) {
      stage_ = Stage::kDone;
      return Progress::kDone;
    }
    law.begin(kRoundsToTry + 1);
    return Progress::kWorking;
  }
  if (extended_) {
    table_.continue_with(law);
    cost_ += static_cast<int>(table_.size() / kPointsPerInterval);
  } else {
    table_.assign(law);
  }
  if (stage_ == Stage::kSearch) {
    measure(law);
    try_next(law);
  } else if (!shape(law)) {
    stage_ = Stage::kDone;
  }
  return stage_ == Stage::kDone ? Progress::kDone : Progress::kWorking;
}

void SmoothLaw::measure(const SpeedLaw& law) noexcept {
  ++tries_without_gain_;
  each_run(table_, [&](std::size_t index, const TableRun& motion) {
    Run& run = runs_[index];
    if (!run.smooth) return;
    plateaus_.find(table_, motion, run.tau_s, law);
    run.time_s = table_[motion.last].t_s - table_[motion.first].t_s + run.tau_s;
    for (std::size_t i = 0; i < plateaus_.size(); ++i) run.time_s += plateaus_[i].longer_s;
    if (run.best_time_s > 0.0 && run.best_time_s <= run.time_s) return;
    tries_without_gain_ = 0;
    run.best_time_s = run.time_s;
    run.best_tau_s = run.tau_s;
  });
}

void SmoothLaw::try_next(SpeedLaw& law) noexcept {
  ++tries_;
  if (tries_ < kCoarseSteps && tries_without_gain_ >= kInVain) tries_ = kCoarseSteps;
  for (std::size_t i = 0; i < count_; ++i) {
    Run& run = runs_[i];
    if (!run.smooth) continue;
    if (tries_ >= kSteps) {
      run.tau_s = seconds(whole_ticks(run.best_tau_s));
    } else {
      run.tau_s = tries_ < kCoarseSteps ? run.tau_s * kCoarse
                                        : run.best_tau_s * kFine[static_cast<std::size_t>(tries_ - kCoarseSteps)];
    }
    run.tau_s = std::max(run.tau_s, kLeastTau_s);
  }
  if (tries_ >= kSteps) stage_ = Stage::kShape;
  rounds_ = 0;
  plan(law);
}

// False: no plateau is needed any more.
bool SmoothLaw::shape(SpeedLaw& law) noexcept {
  if (++rounds_ > (extended_ ? kMaxWindowRounds : kMaxRounds)) return false;
  bool changes = false;
  if (extended_) note_runs();
  each_run(table_, [&](std::size_t index, const TableRun& motion) {
    if (extended_) {
      runs_[index].smooth = true;
      runs_[index].tau_s = seconds(tau_);
    }
    if (!runs_[index].smooth) return;
    const TimeTable::Point joint = extended_ ? table_.kept_end() : TimeTable::Point{};
    plateaus_.find(table_, motion, runs_[index].tau_s, law, extended_ && index == 0 ? &joint : nullptr);
    for (std::size_t i = 0; i < plateaus_.size(); ++i) law.cap(plateaus_[i].from, plateaus_[i].to, plateaus_[i].square);
    changes = changes || plateaus_.size() > 0;
  });
  if (changes) law.begin(kRoundsToTry + 1);
  return changes;
}

Ticks SmoothLaw::later() const noexcept {
  Ticks result{};
  for (std::size_t i = 0; i + 1 < count_; ++i) {
    if (runs_[i].smooth) result = result + whole_ticks(runs_[i].tau_s);
  }
  return result;
}

bool SmoothLaw::keep(TimeTable& average, const TimeTable::Point& joint, double from_s, Ticks origin) noexcept {
  TableRun run;
  while (run.last + 1 < table_.size()) run = run_from(table_, run.last);
  const Ticks tau = whole_ticks(runs_[count_ - 1].tau_s), late = later();
  TimeTable::Point last = joint;
  last.t_s -= seconds(late);
  const double since_s = std::max(last.t_s - seconds(tau), table_[run.first].t_s);
  const TimeTable::Point end{
      .t_s = joint.t_s, .s = average.position(joint.t_s), .speed = average_speed(table_, run, tau, last.t_s)};
  if (!table_.can_keep(since_s, last, TimeTable::kMaxKept) ||
      !average.can_keep(from_s, end, TimeTable::kMaxKeptOfAverage)) {
    return false;
  }
  table_.keep(since_s, last, origin - late);
  average.keep(from_s, end, origin);
  tau_ = tau;
  return true;
}

void SmoothLaw::extend(SpeedLaw& law) noexcept {
  for (std::size_t i = 0; i < law.size(); ++i) {
    LawLimits::Jerk& jerk = law.limits(i).jerk;
    if (jerk.usual_square > 0.0) continue;
    jerk.usual_square = law.square(i);
    if (jerk.by_change > 0.0) limit_jerk(law.limits(i), seconds(tau_));
  }
  extended_ = true;
  stage_ = Stage::kShape;
  rounds_ = 0;
  law.begin(kRoundsToTry + 1);
}

void SmoothLaw::write(TimeTable& table) const noexcept {
  if (extended_) return continue_average(table_, tau_, table);
  std::array<Ticks, kMaxRuns> tau{};
  for (std::size_t i = 0; i < count_; ++i) tau[i] = runs_[i].smooth ? whole_ticks(runs_[i].tau_s) : Ticks{};
  moving_average(table_, std::span{tau}.first(count_), table);
}

double SmoothLaw::tau_s(double s) const noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    if (s <= runs_[i].to) return runs_[i].smooth ? runs_[i].tau_s : 0.0;
  }
  return 0.0;
}

}  // namespace armature
