// Encoder feedback of one axis: finds out how many pulses the drive has lost and sends them again.
//
// The nominal drive (drive_model.hpp) is run on the pulses that were really emitted, corrections included. Where it
// should be minus where the encoder is, is the loss. A correction moves both alike, so it cannot feed back into the
// loss: nothing to tune, no limit cycle, and normal lag is no error.
//
// The real drive is not exactly the nominal one. Its deviation is a share of the lag and fades with it (25 % of the lag
// for a bandwidth 20 % too low), so a larger share of the lag's decaying peak is a dead band around the correction:
// inside it nothing happens. At rest the band shrinks to what an incremental encoder cannot tell, one count.
#pragma once

#include "controller/core/units.hpp"
#include "controller/motion/drive_model.hpp"
#include "controller/robot/axis_units.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class Feedback {
 public:
  Feedback(const AxisModel& model, const AxisUnits& units) noexcept;

  // The axis stands at `measured`; `sent` pulses have been emitted so far. The correction starts again from 0.
  void restart(Pulses sent, Counts measured) noexcept;

  // A tick has ended in which `count` pulses were emitted. To be called for every tick, in order.
  void tick_emitted(Pulses count) noexcept { drive_.step(count); }
  // Of the pulses so reported `count` were not emitted after all.
  void not_emitted(Pulses count) noexcept { drive_.unsend(count); }

  // The correction that the commanded pulses of the next tick should contain, in all since restart(). `measured` is the
  // encoder at the end of the last tick that was reported, `reference_step` what the set-point is about to move
  // [pulses/tick]: the correction uses what it leaves of the axis' speed limit. Once per tick.
  [[nodiscard]] Pulses correct(Counts measured, double reference_step) noexcept;

 private:
  void observe(Counts measured) noexcept;
  void slew(double distance, double reference_step) noexcept;

  AxisUnits units_;
  DriveModel drive_;
  double peak_decay_;      // of the lag's peak, per tick
  double resolution_;      // pulses of one count, at least one pulse
  double offset_ = 0.0;    // measured minus sent at the restart [pulses]
  double loss_ = 0.0;      // filtered [pulses]
  double lag_peak_ = 0.0;  // [pulses]
  bool correcting_ = false;
  double correction_ = 0.0;  // [pulses]
  double speed_ = 0.0;       // of the correction [pulses/tick]
};

}  // namespace armature
