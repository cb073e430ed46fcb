// One axis of the motion loop: computes the count of the next tick from set-point and encoder position.
#pragma once

#include <cmath>
#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/motion/feedback.hpp"
#include "controller/motion/pulse_quantizer.hpp"
#include "controller/robot/axis_units.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class AxisControl {
 public:
  // `feedback` false: pulses are committed open loop.
  AxisControl(const AxisModel& model, bool feedback) noexcept;

  // The axis stands at `measured`, which becomes its set-point; `emitted` is the number of pulses emitted so far.
  void restart(Pulses emitted, Counts measured) noexcept;

  // Sets the committed pulses to `emitted`, whatever was committed before. Valid until the next restart().
  void set_committed(Pulses emitted) noexcept { quantizer_.restart(emitted, reference_pulses_ + correction_); }

  // A tick has ended in which `count` pulses were emitted. Call for every tick, in order.
  void tick_emitted(Pulses count) noexcept { feedback_.tick_emitted(count); }
  // `count` pulses of a commit did not fit in their tick, as the logic reports; next() sends them again.
  void not_emitted(Pulses count) noexcept;

  // In truth `emitted` pulses were emitted so far, and `active` follow in this tick; next() sends what is missing.
  void set_emitted(Pulses emitted, Pulses active) noexcept;

  // The count to commit so that the axis follows `reference`, within the axis' speed limit and the largest count of a
  // tick. With feedback the count includes the correction that `measured` requires.
  [[nodiscard]] Pulses next(Radians reference, Counts measured) noexcept {
    const double step = units_.to_exact_pulses(reference - reference_);
    direction_ = (reference > reference_) - (reference < reference_);
    reference_ = reference;
    reference_pulses_ = units_.to_pulses(reference);
    if (feedback_on_) correction_ = feedback_.correct(measured, step);
    return quantizer_.next(reference_pulses_ + correction_);
  }

  // True when `measured`, the angle of the encoder, is farther from the last set-point than the axis' following-error
  // limit, or from where the pulses should have brought the axis: the feedback has then corrected too much.
  [[nodiscard]] bool following_error(Radians measured) const noexcept {
    return std::fabs((reference_ - measured).value()) > following_error_limit_rad_ ||
           std::fabs(feedback_.loss()) > following_error_limit_;
  }
  // True when `measured` is too far from where the drive would be. Call it every kJudgedTicks ticks, after next().
  static constexpr std::int32_t kJudgedTicks = 2 * kAxes;
  [[nodiscard]] bool judge_deviation(Counts measured) noexcept {
    if (!checks_deviation_) return false;
    if (!feedback_on_) feedback_.observe(measured);
    return feedback_.deviation() > max_deviation_;
  }
  // The encoder has left the drive's nominal motion, by however little: its counts are not certain.
  [[nodiscard]] bool deviates() const noexcept { return feedback_.deviates(); }
  // Joint direction in which the last set-point moved: -1, 0 or 1.
  [[nodiscard]] int direction() const noexcept { return direction_; }

  // The encoder position of the axis after `emitted` pulses, counted from 0.
  [[nodiscard]] Counts counts_of(Pulses emitted) const noexcept { return units_.to_counts(emitted); }
  [[nodiscard]] Radians actual(Counts measured) const noexcept { return units_.to_radians(measured); }
  [[nodiscard]] Radians reference() const noexcept { return reference_; }
  [[nodiscard]] Pulses reference_pulses() const noexcept { return reference_pulses_; }
  [[nodiscard]] Pulses correction() const noexcept { return correction_; }
  [[nodiscard]] Pulses committed() const noexcept { return quantizer_.committed(); }

 private:
  AxisUnits units_;
  double following_error_limit_rad_;
  double following_error_limit_;  // [pulses]
  double max_deviation_;          // [pulses]; infinity: not checked
  bool checks_deviation_;
  bool feedback_on_;
  PulseQuantizer quantizer_;
  Feedback feedback_;
  Radians reference_{};
  Pulses reference_pulses_{};
  Pulses correction_{};
  int direction_ = 0;
};

}  // namespace armature
