// The law of a path with limited jerk: a law whose moving average over a time tau keeps the limits
// (moving_average.hpp).
//
// Each motion between two stops has its own tau. A long one allows larger accelerations, but makes the motion longer.
// The law is planned for several, and the one with the shortest motion is used. Then the peaks and valleys that are too
// sharp for it are made plateaus (plateaus.hpp), until there are none.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/core/units.hpp"
#include "controller/trajectory/law/plateaus.hpp"
#include "controller/trajectory/law/speed_law.hpp"
#include "controller/trajectory/law/time_table.hpp"
#include "controller/trajectory/plan/cartesian_plan.hpp"

namespace armature {

class SmoothLaw {
 public:
  enum class Progress : std::uint8_t { kWorking, kDone };

  // Starts with a law that was planned without limits of jerk. Returns false if none of its motions has any. The law
  // must be the same for all calls.
  bool begin(SpeedLaw& law) noexcept;
  // Continues with the same tau after limits of the law were lowered.
  void plan_again(SpeedLaw& law) noexcept;
  // Continues for about this many intervals of the law. kDone: the law is that of the plan.
  Progress work(SpeedLaw& law, std::size_t intervals) noexcept;

  // kDone: the motion.
  void write(TimeTable& table) const noexcept;
  // tau of the motion at this place, s.
  [[nodiscard]] double tau_s(double s) const noexcept;

 private:
  static constexpr std::size_t kMostRuns = CartesianPlan::kMaxSegments;
  static constexpr int kMostRounds = 12;  // of plateaus

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
  void plan(SpeedLaw& law) noexcept;
  void measure(const SpeedLaw& law) noexcept;
  void try_next(SpeedLaw& law) noexcept;
  [[nodiscard]] bool shape(SpeedLaw& law) noexcept;

  Stage stage_ = Stage::kDone;
  std::array<Run, kMostRuns> runs_{};
  std::size_t count_ = 0;
  int tried_ = 0, rounds_ = 0;
  int in_vain_ = 0;    // tries since the last better one
  TimeTable table_{};  // of the law
  Plateaus plateaus_{};
};

}  // namespace armature
