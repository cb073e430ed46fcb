#include "cosim/train/belt_examples.hpp"

#include <algorithm>
#include <cmath>

#include "controller/base/math.hpp"
#include "controller/base/timebase.hpp"
#include "controller/motion/set_point_source.hpp"
#include "cosim/belt/belt_motion.hpp"
#include "cosim/time/random.hpp"

namespace armature::cosim {
namespace {

constexpr double kRun_s = 1.0;
constexpr std::int64_t kSettled = 3'000;  // ticks until an observer has forgotten that it began
constexpr std::int64_t kRunTicks = 19'800;
constexpr double kMostSpeed = 200;                       // mm/s
constexpr double kLeastAccel = 500, kMostAccel = 4'000;  // mm/s^2

// Its speed changes again and again, also while it changes; its drum is not quite round.
ConveyorSpec random_belt(Random& random, const BeltTask& task) {
  ConveyorSpec belt;
  belt.mm_per_count = task.mm_per_count;
  belt.lead_ms = task.lead_ms;
  belt.speed_mm_s = random.between(0, kMostSpeed);
  belt.belt_accel_mm_s2 = random.between(kLeastAccel, kMostAccel);
  for (double at_s = random.between(0.1, 0.3); at_s < kRun_s; at_s += random.between(0.1, 0.4)) {
    belt.speeds.push_back({.at_s = at_s, .speed_mm_s = random.between(0, kMostSpeed)});
  }
  belt.wave_mm = random.between(0, 0.3);
  belt.wave_length_mm = random.between(300, 600);
  return belt;
}

AxisState belt_at(const BeltMotion& belt, double t_s) {
  constexpr double kStep_s = 1e-4;
  const double before = belt.position_mm(t_s - kStep_s), now = belt.position_mm(t_s),
               after = belt.position_mm(t_s + kStep_s);
  return {.position = now,
          .velocity = (after - before) / (2 * kStep_s),
          .accel = (after + before - 2 * now) / (kStep_s * kStep_s)};
}

double look_ahead_s(const BeltTask& task) {
  return kTicksToEmit * kTickSeconds + task.lead_ms * 1e-3;
}

// Advances a belt and its observer by a tick.
class BeltRun {
 public:
  BeltRun(Random& random, const BeltTask& task, const ConveyorBelt::Bandwidths& bandwidths)
      : motion_{random_belt(random, task)},
        belt_{task.mm_per_count, look_ahead_s(task), bandwidths},
        ahead_s_{look_ahead_s(task)} {}

  void advance(std::int64_t tick, double correction_mm) {
    const double t_s = static_cast<double>(tick) * kTickSeconds;
    belt_.sample(motion_.counts(t_s), Ticks{tick}, correction_mm);
    observation_.add(belt_);
    coming_ = belt_at(motion_, t_s + ahead_s_);
  }
  [[nodiscard]] const ConveyorBelt& belt() const { return belt_; }
  [[nodiscard]] const AxisState& coming() const { return coming_; }  // where the belt should be expected
  [[nodiscard]] const BeltObservation::Values& observation() const { return observation_.values(); }

 private:
  BeltMotion motion_;
  ConveyorBelt belt_;
  BeltObservation observation_;
  double ahead_s_;
  AxisState coming_{};
};

// The one with which the second system of ConveyorBelt stays on the belt that comes.
double best_correction(const BeltRun& run) {
  constexpr double kBandwidth = ConveyorBelt::kBandwidth;
  const AxisState &coming = run.coming(), &target = run.belt().target();
  return coming.position - target.position - target.velocity * kTickSeconds +
         2 / kBandwidth * (coming.velocity - target.velocity) +
         (coming.accel - run.belt().accel_mm_s2()) / (kBandwidth * kBandwidth);
}

// Sums of a run.
class ErrorSums {
 public:
  void add(const BeltRun& run) {
    const double error_mm = run.belt().expected().position - run.coming().position;
    squares_ += error_mm * error_mm;
    errors_.worst_mm = std::max(errors_.worst_mm, std::fabs(error_mm));
    ++count_;
    constexpr double kSteadyAccel = 50;  // mm/s^2
    constexpr int kQuietTicks = 800;     // 40 ms: until a change has been forgotten
    quiet_ = std::fabs(run.coming().accel) < kSteadyAccel ? quiet_ + 1 : 0;
    if (quiet_ <= kQuietTicks) return;
    unrest_ += math::square(run.belt().expected().accel - run.coming().accel);
    ++quiet_count_;
  }
  void begin_belt() { quiet_ = 0; }
  [[nodiscard]] BeltErrors errors() const {
    BeltErrors errors = errors_;
    if (count_ > 0) errors.rms_mm = std::sqrt(squares_ / static_cast<double>(count_));
    if (quiet_count_ > 0) errors.unrest_mm_s2 = std::sqrt(unrest_ / static_cast<double>(quiet_count_));
    return errors;
  }

 private:
  BeltErrors errors_;
  double squares_ = 0, unrest_ = 0;
  std::int64_t count_ = 0, quiet_count_ = 0;
  int quiet_ = 0;
};

}  // namespace

std::vector<BeltExample> belt_examples(std::uint64_t seed, std::size_t belts, const BeltTask& task) {
  constexpr std::uint64_t kEvery = 16;  // neighbours in time tell the same
  Random random{seed};
  std::vector<BeltExample> examples;
  for (std::size_t i = 0; i < belts; ++i) {
    BeltRun run{random, task, {}};
    for (std::int64_t tick = 0; tick < kRunTicks; ++tick) {
      run.advance(tick, 0);
      if (tick < kSettled || random.next() % kEvery != 0) continue;
      examples.push_back({.inputs = run.observation(),
                          .correction_mm = std::clamp(best_correction(run), -task.full_mm, task.full_mm)});
    }
  }
  return examples;
}

BeltErrors belt_errors(std::uint64_t seed, std::size_t belts, const BeltTask& task,
                       const ConveyorBelt::Bandwidths& bandwidths, const BeltAnswer& answer) {
  Random random{seed};
  ErrorSums sums;
  for (std::size_t i = 0; i < belts; ++i) {
    BeltRun run{random, task, bandwidths};
    double correction_mm = 0;
    sums.begin_belt();
    for (std::int64_t tick = 0; tick < kRunTicks; ++tick) {
      run.advance(tick, correction_mm);
      if (answer) correction_mm = answer(run.observation());
      if (tick >= kSettled) sums.add(run);
    }
  }
  return sums.errors();
}

}  // namespace armature::cosim
