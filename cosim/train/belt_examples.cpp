#include "cosim/train/belt_examples.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "controller/base/math.hpp"
#include "controller/base/timebase.hpp"
#include "controller/motion/set_point_source.hpp"
#include "cosim/belt/belt_camera.hpp"
#include "cosim/belt/belt_motion.hpp"
#include "cosim/belt/measured_belt.hpp"
#include "cosim/time/random.hpp"

namespace armature::cosim {
namespace {

// The ranges of what is drawn, and of what is used of a run.
struct TargetKind {
  double run_s, settled_s;               // until an observer has forgotten that it began
  double least_speed, most_speed;        // mm/s
  double least_accel, most_accel;        // mm/s^2
  double least_change_s, most_change_s;  // from change to change
  double most_wave_mm;
  double quiet_s;  // until a change has been forgotten
};

constexpr TargetKind kBelt{.run_s = 0.99,
                           .settled_s = 0.15,
                           .least_speed = 0,
                           .most_speed = 200,
                           .least_accel = 500,
                           .most_accel = 4'000,
                           .least_change_s = 0.1,
                           .most_change_s = 0.4,
                           .most_wave_mm = 0.3,
                           .quiet_s = 0.04};
constexpr TargetKind kHand{.run_s = 3,
                           .settled_s = 1,
                           .least_speed = -150,
                           .most_speed = 150,
                           .least_accel = 300,
                           .most_accel = 1'500,
                           .least_change_s = 0.2,
                           .most_change_s = 0.8,
                           .most_wave_mm = 0,
                           .quiet_s = 0.1};

const TargetKind& target_kind(const BeltTask& task) {
  return task.camera ? kHand : kBelt;
}

std::int64_t ticks_of(double time_s) {
  return std::llround(time_s / kTickSeconds);
}

// Its speed changes again and again, also while it changes; the drum of a belt is not quite round.
ConveyorSpec random_belt(Random& random, const BeltTask& task) {
  const TargetKind& kind = target_kind(task);
  ConveyorSpec belt;
  belt.mm_per_count = task.mm_per_count;
  belt.lead_ms = task.lead_ms;
  belt.speed_mm_s = random.between(kind.least_speed, kind.most_speed);
  belt.belt_accel_mm_s2 = random.between(kind.least_accel, kind.most_accel);
  // The margin is needed only for networks that were trained with it: without it, all later draws would be others.
  constexpr double kMargin_s = 0.01;
  for (double at_s = random.between(0.1, 0.3); at_s < kind.run_s + kMargin_s;
       at_s += random.between(kind.least_change_s, kind.most_change_s)) {
    belt.speeds.push_back({.at_s = at_s, .speed_mm_s = random.between(kind.least_speed, kind.most_speed)});
  }
  belt.wave_mm = random.between(0, kind.most_wave_mm);
  belt.wave_length_mm = random.between(300, 600);
  return belt;
}

MeasuredBelt random_target(Random& random, const BeltTask& task) {
  ConveyorSpec spec = random_belt(random, task);
  spec.camera = task.camera;
  const std::uint64_t noise_seed = task.camera ? random.next() : 0;
  return {spec, noise_seed};
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

std::optional<BeltCamera> camera_of(const BeltTask& task) {
  return task.camera ? std::optional{to_camera(*task.camera)} : std::nullopt;
}

// Advances a belt and its observer by a tick.
class BeltRun {
 public:
  BeltRun(Random& random, const BeltTask& task, const ConveyorBelt::Bandwidths& bandwidths)
      : real_{random_target(random, task)},
        belt_{task.mm_per_count, look_ahead_s(task), bandwidths},
        observation_{camera_of(task)},
        ahead_s_{look_ahead_s(task)},
        second_{bandwidths.second} {}

  void advance(std::int64_t tick, double correction_mm) {
    const double t_s = static_cast<double>(tick) * kTickSeconds;
    if (const auto sample = real_.sample(Ticks{tick}, t_s)) {
      belt_.measure(sample->counts, sample->taken);
      observation_.add(belt_);
    }
    belt_.expect(Ticks{tick}, correction_mm);
    coming_ = belt_at(real_.motion(), t_s + ahead_s_);
  }
  // The correction with which the second system of ConveyorBelt stays on the belt that comes.
  [[nodiscard]] double best_correction() const {
    const AxisState& target = belt_.target();
    return coming_.position - target.position - target.velocity * kTickSeconds +
           2 / second_ * (coming_.velocity - target.velocity) +
           (coming_.accel - belt_.accel_mm_s2()) / (second_ * second_);
  }
  [[nodiscard]] const ConveyorBelt& belt() const { return belt_; }
  [[nodiscard]] const AxisState& coming() const { return coming_; }  // where the belt should be expected
  [[nodiscard]] const BeltObservation::Values& observation() const { return observation_.values(); }

 private:
  MeasuredBelt real_;
  ConveyorBelt belt_;
  BeltObservation observation_;
  double ahead_s_, second_;
  AxisState coming_{};
};

// Sums of a run.
class ErrorSums {
 public:
  explicit ErrorSums(const TargetKind& kind) : quiet_ticks_{ticks_of(kind.quiet_s)} {}
  void add(const BeltRun& run) {
    const double error_mm = run.belt().expected().position - run.coming().position;
    squares_ += error_mm * error_mm;
    errors_.worst_mm = std::max(errors_.worst_mm, std::fabs(error_mm));
    ++count_;
    constexpr double kSteadyAccel = 50;  // mm/s^2
    quiet_ = std::fabs(run.coming().accel) < kSteadyAccel ? quiet_ + 1 : 0;
    if (quiet_ <= quiet_ticks_) return;
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
  std::int64_t quiet_ = 0, quiet_ticks_;
};

}  // namespace

ConveyorBelt::Bandwidths bandwidths_of(const BeltTask& task) {
  return ConveyorBelt::bandwidths_for(camera_of(task));
}

std::vector<BeltExample> belt_examples(std::uint64_t seed, std::size_t belts, const BeltTask& task) {
  constexpr std::uint64_t kEvery = 16;  // neighbours in time tell the same
  const TargetKind& kind = target_kind(task);
  Random random{seed};
  std::vector<BeltExample> examples;
  for (std::size_t i = 0; i < belts; ++i) {
    BeltRun run{random, task, bandwidths_of(task)};
    for (std::int64_t tick = 0; tick < ticks_of(kind.run_s); ++tick) {
      run.advance(tick, 0);
      if (tick < ticks_of(kind.settled_s) || random.next() % kEvery != 0) continue;
      examples.push_back({.inputs = run.observation(),
                          .correction_mm = std::clamp(run.best_correction(), -task.full_mm, task.full_mm)});
    }
  }
  return examples;
}

BeltErrors belt_errors(std::uint64_t seed, std::size_t belts, const BeltTask& task,
                       const ConveyorBelt::Bandwidths& bandwidths, const BeltAnswer& answer) {
  const TargetKind& kind = target_kind(task);
  Random random{seed};
  ErrorSums sums{kind};
  for (std::size_t i = 0; i < belts; ++i) {
    BeltRun run{random, task, bandwidths};
    double correction_mm = 0;
    sums.begin_belt();
    for (std::int64_t tick = 0; tick < ticks_of(kind.run_s); ++tick) {
      run.advance(tick, correction_mm);
      if (answer) correction_mm = answer(run.observation());
      if (tick >= ticks_of(kind.settled_s)) sums.add(run);
    }
  }
  return sums.errors();
}

}  // namespace armature::cosim
