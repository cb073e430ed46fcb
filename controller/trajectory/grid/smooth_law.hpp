// The law of a path with limited jerk: a law whose moving average over a time tau keeps the limits
// (moving_average.hpp).
//
// Each motion between two stops has its own tau. A long one allows larger accelerations, but makes the motion longer.
// The law is planned for several, and the one with the shortest motion is used. Then the peaks and valleys that are too
// sharp for it are made plateaus (plateaus.hpp), until there are none.
//
// The last motion can be continued while it is executed, with the same tau. Up to a time, its average depends only on
// the law up to that time, so the law continues at its own joint, ahead of the average.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/base/units.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/law/moving_average.hpp"
#include "controller/trajectory/law/plateaus.hpp"
#include "controller/trajectory/law/speed_law.hpp"
#include "controller/trajectory/law/time_table.hpp"

namespace armature {

class SmoothLaw {
 public:
  enum class Progress : std::uint8_t { kWorking, kDone };

  // Starts with a law that was planned without limits of jerk. Returns false if none of its motions has any. The law
  // must be the same for all calls.
  bool begin(SpeedLaw& law) noexcept;
  // Continues with the same tau after limits of the law were lowered.
  void plan_again(SpeedLaw& law) noexcept;
  // Continues for about this many intervals of the law. kDone: the law is that of the plan. After extend() the law may
  // not start as asked then; there is no plan in that case.
  Progress work(SpeedLaw& law, std::size_t intervals) noexcept;
  // The cost of the last work(), in intervals of the law.
  [[nodiscard]] int cost() const noexcept { return cost_; }

  // To continue the plan of write(). True when its last motion is smooth.
  [[nodiscard]] bool can_continue() const noexcept { return count_ > 0 && runs_[count_ - 1].smooth; }
  // The law of the plan over time. In the last motion, the time of the plan is later by later().
  [[nodiscard]] const TimeTable& table() const noexcept { return table_; }
  [[nodiscard]] Ticks later() const noexcept;
  // Where the last motion begins.
  [[nodiscard]] double last_from() const noexcept { return runs_[count_ - 1].from; }
  // Keeps the table `average` of write() from `from_s` on up to a joint of the last motion, a point of the law with the
  // time of the plan; the time is then counted from tick `origin` on. False, and nothing is changed: too many points.
  [[nodiscard]] bool keep(TimeTable& average, const TimeTable::Point& joint, double from_s, Ticks origin) noexcept;
  // Continues with `law`, which begins at the joint. Its passes are done, with limits of jerk only at those points that
  // were in the plan before and where Jerk::usual_square is above 0.
  void extend(SpeedLaw& law) noexcept;

  // kDone: the motion. After extend(), `table` is that of keep().
  void write(TimeTable& table) const noexcept;
  // tau of the motion at this place, s.
  [[nodiscard]] double tau_s(double s) const noexcept;

 private:
  static constexpr std::size_t kMaxRuns = CartesianPlan::kMaxSegments;
  // Of plateaus; a window has less time for them. What is too sharp then becomes slower by the check of the set-points.
  static constexpr int kMaxRounds = 12, kMaxWindowRounds = 4;

  // A motion between two stops.
  struct Run {
    double from = 0.0, to = 0.0;
    bool smooth = false;
    double tau_s = 0.0, time_s = 0.0;            // the last tried
    double best_tau_s = 0.0, best_time_s = 0.0;  // time_s 0: none
  };
  enum class Stage : std::uint8_t { kSearch, kShape, kDone };

  [[nodiscard]] std::size_t run_of(const SpeedLaw& law, std::size_t point, std::size_t run) const noexcept;
  void find_runs(SpeedLaw& law) noexcept;
  void note_runs() noexcept;
  void plan(SpeedLaw& law) noexcept;
  void measure(const SpeedLaw& law) noexcept;
  void try_next(SpeedLaw& law) noexcept;
  [[nodiscard]] bool shape(SpeedLaw& law) noexcept;

  Stage stage_ = Stage::kDone;
  std::array<Run, kMaxRuns> runs_{};
  std::size_t count_ = 0;
  int tries_ = 0, rounds_ = 0;
  int tries_without_gain_ = 0;  // tries since the last better one
  int cost_ = 0;
  bool extended_ = false;
  Ticks tau_{};        // of all motions of an extended plan
  TimeTable table_{};  // of the law
  Plateaus plateaus_{};
};

}  // namespace armature
