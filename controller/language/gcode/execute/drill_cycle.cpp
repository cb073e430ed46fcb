#include "controller/language/gcode/execute/drill_cycle.hpp"

namespace armature::gcode {

void DrillCycle::begin(const DrillRequest& request) noexcept {
  request_ = request;
  place_ = request.from;
  hole_ = 0;
  phase_ = Phase::kApproach;
  if (request.rise_first) traverse_to(request.clearance);
  if (request.control.mode != SetMotionControlMode::Mode::kExactPath) {
    calls_.emit(SetMotionControlMode{.mode = SetMotionControlMode::Mode::kExactPath});
  }
}

void DrillCycle::step() noexcept {
  const PlaneAxes axes = axes_of(request_.plane);
  switch (phase_) {
    case Phase::kApproach: {
      const double height = hole_ == 0 ? request_.approach : request_.retract;
      place_[axes.first] = request_.first + hole_ * request_.first_step;
      place_[axes.second] = request_.second + hole_ * request_.second_step;
      traverse_to(height);
      if (height > request_.clearance) traverse_to(request_.clearance);
      depth_ = request_.clearance - request_.peck;
      phase_ = Phase::kPeck;
      return;
    }
    case Phase::kPeck:
      if (request_.peck > 0.0 && depth_ > request_.bottom) {
        feed_to(depth_);
        if (!request_.breaks_chips) traverse_to(request_.clearance);
        traverse_to(depth_ + request_.peck_clearance);
        depth_ -= request_.peck;
        return;
      }
      if (request_.tap != 0) {
        tap();
        phase_ = Phase::kRetract;
        return;
      }
      feed_to(request_.bottom);
      if (request_.dwell_s) calls_.emit(Dwell{*request_.dwell_s});
      phase_ = Phase::kRetract;
      return;
    case Phase::kRetract:
      if (request_.tap == 0) traverse_to(request_.retract);
      ++hole_;
      phase_ = Phase::kApproach;
      if (hole_ < request_.repeats) return;
      phase_ = Phase::kDone;
      if (request_.control.mode != SetMotionControlMode::Mode::kExactPath) {
        calls_.emit(request_.control);
        calls_.emit(SetNaiveCamTolerance{request_.naive_cam_mm});
      }
      return;
    case Phase::kDone:
      return;
  }
}

// The tool goes in and out at the feed of the thread, so nothing may change it.
void DrillCycle::tap() noexcept {
  using Kind = EnableOverride::Kind;
  calls_.emit(EnableOverride{.kind = Kind::kFeed, .on = false});
  calls_.emit(EnableOverride{.kind = Kind::kSpeed, .on = false});
  feed_to(request_.bottom);
  turn_spindle(request_.tap < 0);
  calls_.emit(Dwell{request_.dwell_s.value_or(0.0)});
  feed_to(request_.retract);
  turn_spindle(request_.tap > 0);
  if (request_.feed_override) calls_.emit(EnableOverride{.kind = Kind::kFeed, .on = true});
  if (request_.speed_override) calls_.emit(EnableOverride{.kind = Kind::kSpeed, .on = true});
}

void DrillCycle::turn_spindle(bool clockwise) noexcept {
  calls_.emit(StopSpindle{});
  calls_.emit(StartSpindle{clockwise});
}

void DrillCycle::traverse_to(double height) noexcept {
  place_[axes_of(request_.plane).normal] = height;
  calls_.emit(StraightTraverse{place_});
}

void DrillCycle::feed_to(double height) noexcept {
  place_[axes_of(request_.plane).normal] = height;
  calls_.emit(StraightFeed{place_});
}

}  // namespace armature::gcode
