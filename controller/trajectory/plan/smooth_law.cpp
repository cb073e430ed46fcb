#include "controller/trajectory/plan/smooth_law.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "controller/core/timebase.hpp"
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

// Calls visit(run, first, last) for each motion between two stops, with the points of the table.
template <class Visit>
void each_run(const TimeTable& table, Visit visit) {
  std::size_t run = 0;
  for (std::size_t first = 0; first + 1 < table.size(); ++run) {
    std::size_t last = first + 1;
    while (table[last].speed > 0.0) ++last;
    visit(run, first, last);
    first = last;
  }
}

}  // namespace

bool SmoothLaw::begin(SpeedLaw& law) noexcept {
  find_runs(law);
  const auto is_smooth = [](const Run& run) { return run.smooth; };
  if (std::none_of(runs_.begin(), runs_.begin() + static_cast<std::ptrdiff_t>(count_), is_smooth)) {
    stage_ = Stage::kDone;
    return false;
  }
  stage_ = Stage::kSearch;
  tried_ = in_vain_ = 0;
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
  count_ = 0;
  each_run(table_, [&](std::size_t, std::size_t first, std::size_t last) {
    runs_[count_++] = {.from = table_[first].s, .to = table_[last].s};
  });
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

void SmoothLaw::plan(SpeedLaw& law) noexcept {
  law.free();
  std::size_t run = 0;
  for (std::size_t i = 0; i < law.size(); ++i) {
    run = run_of(law, i, run);
    if (runs_[run].smooth && law.limits(i).jerk.by_change > 0.0) limit_jerk(law.limits(i), runs_[run].tau_s);
  }
  law.begin(stage_ == Stage::kSearch ? kRoundsToTry : SpeedLaw::kMostRounds);
}

void SmoothLaw::plan_again(SpeedLaw& law) noexcept {
  stage_ = Stage::kShape;
  rounds_ = 0;
  law.begin();
}

SmoothLaw::Progress SmoothLaw::work(SpeedLaw& law, std::size_t intervals) noexcept {
  if (stage_ == Stage::kDone) return Progress::kDone;
  if (law.work(intervals) == SpeedLaw::Progress::kWorking) return Progress::kWorking;
  table_.assign(law);
  if (stage_ == Stage::kSearch) {
    measure(law);
    try_next(law);
  } else if (!shape(law)) {
    stage_ = Stage::kDone;
  }
  return stage_ == Stage::kDone ? Progress::kDone : Progress::kWorking;
}

void SmoothLaw::measure(const SpeedLaw& law) noexcept {
  ++in_vain_;
  each_run(table_, [&](std::size_t index, std::size_t first, std::size_t last) {
    Run& run = runs_[index];
    if (!run.smooth) return;
    plateaus_.find(table_, first, last, run.tau_s, law);
    run.time_s = table_[last].t_s - table_[first].t_s + run.tau_s;
    for (std::size_t i = 0; i < plateaus_.size(); ++i) run.time_s += plateaus_[i].longer_s;
    if (run.best_time_s > 0.0 && run.best_time_s <= run.time_s) return;
    in_vain_ = 0;
    run.best_time_s = run.time_s;
    run.best_tau_s = run.tau_s;
  });
}

void SmoothLaw::try_next(SpeedLaw& law) noexcept {
  ++tried_;
  if (tried_ < kCoarseSteps && in_vain_ >= kInVain) tried_ = kCoarseSteps;
  for (std::size_t i = 0; i < count_; ++i) {
    Run& run = runs_[i];
    if (!run.smooth) continue;
    if (tried_ >= kSteps) {
      run.tau_s = seconds(whole_ticks(run.best_tau_s));
    } else {
      run.tau_s = tried_ < kCoarseSteps ? run.tau_s * kCoarse
                                        : run.best_tau_s * kFine[static_cast<std::size_t>(tried_ - kCoarseSteps)];
    }
    run.tau_s = std::max(run.tau_s, kLeastTau_s);
  }
  if (tried_ >= kSteps) stage_ = Stage::kShape;
  rounds_ = 0;
  plan(law);
}

// False: no plateau is needed any more.
bool SmoothLaw::shape(SpeedLaw& law) noexcept {
  if (++rounds_ > kMostRounds) return false;
  bool changes = false;
  each_run(table_, [&](std::size_t index, std::size_t first, std::size_t last) {
    if (!runs_[index].smooth) return;
    plateaus_.find(table_, first, last, runs_[index].tau_s, law);
    for (std::size_t i = 0; i < plateaus_.size(); ++i) law.cap(plateaus_[i].from, plateaus_[i].to, plateaus_[i].square);
    changes = changes || plateaus_.size() > 0;
  });
  if (changes) law.begin(kRoundsToTry + 1);
  return changes;
}

void SmoothLaw::write(TimeTable& table) const noexcept {
  std::array<Ticks, kMostRuns> tau{};
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
