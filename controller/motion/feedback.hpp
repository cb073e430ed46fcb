// Encoder feedback of one axis: computes how many pulses the drive has lost and sends them again.
//
// The nominal drive (drive_model.hpp) is run on the pulses that were really emitted, corrections included. The loss is
// its position minus the encoder position. A correction moves both equally, so it does not change the loss: there is no
// gain to tune, no limit cycle, and normal lag is not an error.
//
// An encoder that stands still turns a motion of the arm into a loss that no correction ends: the arm would run away
// while set-point and encoder stay near each other. So loss() has a limit, too (axis_control.hpp).
//
// The real drive differs from the nominal one. The deviation is a share of the lag and decays with it (25 % of the lag
// for a bandwidth 20 % too low). So the correction has a dead band: a larger share of the lag's decaying peak. At rest
// the band shrinks to the resolution of an incremental encoder, one count.
#pragma once

#include <cmath>
#include <cstdint>

#include "controller/base/units.hpp"
#include "controller/motion/drive_model.hpp"
#include "controller/robot/axis_units.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class Feedback {
 public:
  // `ticks`: from one correct() or observe() to the next.
  Feedback(const AxisModel& model, const AxisUnits& units, std::int32_t ticks = 1) noexcept;

  // The axis stands at `measured`; `sent` is the number of pulses emitted so far. The correction starts again from 0.
  void restart(Pulses sent, Counts measured) noexcept;

  // A tick has ended in which `count` pulses were emitted. Call for every tick, in order.
  void tick_emitted(Pulses count) noexcept { drive_.step(count); }
  // Corrects tick_emitted(): `count` of its pulses were not emitted.
  void not_emitted(Pulses count) noexcept { drive_.subtract(count); }

  // The correction, in all since restart(), that the commanded pulses of the next tick must contain. `measured` is the
  // encoder at the end of the last reported tick. `reference_step` is the next change of the set-point [pulses/tick]:
  // the correction uses the rest of the axis' speed limit.
  [[nodiscard]] Pulses correct(Counts measured, double reference_step) noexcept;

  // Open loop, instead of correct(): only the deviation is measured.
  void observe(Counts measured) noexcept;

  // The pulses emitted so far, as of restart() and tick_emitted().
  [[nodiscard]] Pulses sent() const noexcept { return drive_.sent(); }
  // What the drive seems to have lost since restart(), corrected or not [pulses].
  [[nodiscard]] double loss() const noexcept { return loss_; }
  // How far the encoder is from where the nominal drive would be, less what a real drive may deviate [pulses].
  [[nodiscard]] double deviation() const noexcept { return std::fabs(loss_ - correction_) - kBandOfLag * lag_peak_; }
  // More than what the feedback leaves alone.
  [[nodiscard]] bool deviates() const noexcept { return deviation() > kStartBand * resolution_; }

 private:
  // The dead band as a share of the peak of the lag. A quarter of the lag is the deviation of a drive whose bandwidth
  // is 20 % too low.
  static constexpr double kBandOfLag = 0.6;
  // A correction starts with more than this beyond the band [counts].
  static constexpr double kStartBand = 1.25;

  void slew(double distance, double reference_step) noexcept;

  AxisUnits units_;
  DriveModel drive_;
  double loss_share_;      // of a new loss in the filtered one
  double peak_decay_;      // of the lag's peak, from one correct() or observe() to the next
  double resolution_;      // pulses of one count, at least one pulse
  double offset_ = 0.0;    // measured minus sent at the restart [pulses]
  double loss_ = 0.0;      // filtered [pulses]
  double lag_peak_ = 0.0;  // [pulses]
  bool correcting_ = false;
  double correction_ = 0.0;  // [pulses]
  double speed_ = 0.0;       // of the correction [pulses/tick]
};

}  // namespace armature
