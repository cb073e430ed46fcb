#include "controller/motion/feedback.hpp"

#include <algorithm>
#include <cmath>

#include "controller/base/rounding.hpp"
#include "controller/base/timebase.hpp"

namespace armature {
namespace {

// Much faster than the drive: the filter only smooths the steps of the encoder. A slower one would add delay, and delay
// needs a wider dead band.
constexpr double kLossFilterSeconds = 0.002;
constexpr double kLossShare = kTickSeconds / kLossFilterSeconds;
// How much slower than the drive the peak of the lag decays. With the dead band found by simulation: the smallest round
// values that keep the correction at 0 for bandwidths 20 % off in either direction, with margin.
constexpr double kPeakDecayOfNatural = 0.33;
// A correction ends below this, in counts or pulses, whichever is coarser.
constexpr double kEndBand = 0.25;

}  // namespace

Feedback::Feedback(const AxisModel& model, const AxisUnits& units, std::int32_t ticks) noexcept
    : units_{units},
      drive_{model.drive_natural_rad_s, model.drive_damping},
      loss_share_{ticks * kLossShare},
      peak_decay_{std::max(0.0, 1.0 - ticks * (kPeakDecayOfNatural * model.drive_natural_rad_s * kTickSeconds))},
      resolution_{std::max(1.0, units.pulses_per_count())} {}

void Feedback::restart(Pulses sent, Counts measured) noexcept {
  drive_.restart(sent);
  offset_ = units_.to_exact_pulses(measured) - static_cast<double>(sent.value());
  loss_ = lag_peak_ = correction_ = speed_ = 0.0;
  correcting_ = false;
}

Pulses Feedback::correct(Counts measured, double reference_step) noexcept {
  observe(measured);
  const double band = kBandOfLag * lag_peak_;
  const double missing = loss_ - correction_;
  if (std::fabs(missing) > band + kStartBand * resolution_) correcting_ = true;
  if (correcting_) {
    const double beyond_band = missing - std::clamp(missing, -band, band);
    slew(beyond_band, reference_step);
    const bool at_rest = band < kStartBand * resolution_;
    correcting_ = speed_ != 0.0 || std::fabs(at_rest ? missing : beyond_band) > kEndBand * resolution_;
  }
  return Pulses{round_half_away(correction_)};
}

void Feedback::observe(Counts measured) noexcept {
  const double loss =
      (static_cast<double>(drive_.sent().value()) + offset_ - units_.to_exact_pulses(measured)) - drive_.lag();
  loss_ += loss_share_ * (loss - loss_);
  lag_peak_ = std::max(std::fabs(drive_.lag()), lag_peak_ * peak_decay_);
}

void Feedback::slew(double distance, double reference_step) noexcept {
  const double accel = units_.max_pulses_per_tick2();
  const bool same_way = (distance < 0.0) == (reference_step < 0.0);
  const double top_speed = std::max(0.0, units_.max_pulses_per_tick() - (same_way ? std::fabs(reference_step) : 0.0));
  // The speed from which braking with `accel`, after one more tick, ends at the target.
  const double braking_speed = std::sqrt(0.25 * accel * accel + 2.0 * accel * std::fabs(distance)) - 0.5 * accel;
  const double wanted = std::copysign(std::min(braking_speed, top_speed), distance);
  speed_ = std::clamp(wanted, speed_ - accel, speed_ + accel);
  correction_ += speed_;
}

}  // namespace armature
