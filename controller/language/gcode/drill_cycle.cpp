#include "controller/language/gcode/drill_cycle.hpp"

namespace armature::gcode {

void DrillCycle::begin(const DrillRequest& request, CanonSink& sink, std::uint32_t line) noexcept {
  request_ = request;
  place_ = request.from;
  hole_ = 0;
  line_ = line;
  phase_ = Phase::kApproach;
  if (request.rise_first) traverse_to(request.clearance, sink);
  if (request.control.mode != SetMotionControlMode::Mode::kExactPath) {
    sink.on_call(SetMotionControlMode{.mode = SetMotionControlMode::Mode::kExactPath}, line);
  }
}

void DrillCycle::step(CanonSink& sink) noexcept {
  const PlaneAxes axes = axes_of(request_.plane);
  switch (phase_) {
    case Phase::kApproach: {
      const double height = hole_ == 0 ? request_.approach : request_.retract;
      place_[axes.first] = request_.first + hole_ * request_.first_step;
      place_[axes.second] = request_.second + hole_ * request_.second_step;
      traverse_to(height, sink);
      if (height > request_.clearance) traverse_to(request_.clearance, sink);
      depth_ = request_.clearance - request_.peck;
      phase_ = Phase::kPeck;
      return;
    }
    case Phase::kPeck:
      if (request_.peck > 0.0 && depth_ > request_.bottom) {
        feed_to(depth_, sink);
        if (!request_.breaks_chips) traverse_to(request_.clearance, sink);
        traverse_to(depth_ + request_.peck_clearance, sink);
        depth_ -= request_.peck;
        return;
      }
      if (request_.tap != 0) {
        tap(sink);
        phase_ = Phase::kRetract;
        return;
      }
      feed_to(request_.bottom, sink);
      if (request_.dwell_s) sink.on_call(Dwell{*request_.dwell_s}, line_);
      phase_ = Phase::kRetract;
      return;
    case Phase::kRetract:
      if (request_.tap == 0) traverse_to(request_.retract, sink);
      ++hole_;
      phase_ = Phase::kApproach;
      if (hole_ < request_.repeats) return;
      phase_ = Phase::kDone;
      if (request_.control.mode != SetMotionControlMode::Mode::kExactPath) {
        sink.on_call(request_.control, line_);
        sink.on_call(SetNaiveCamTolerance{request_.naive_cam_mm}, line_);
      }
      return;
    case Phase::kDone:
      return;
  }
}

// The tool goes in and out at the feed of the thread, so nothing may change it.
void DrillCycle::tap(CanonSink& sink) noexcept {
  using Kind = EnableOverride::Kind;
  sink.on_call(EnableOverride{.kind = Kind::kFeed, .on = false}, line_);
  sink.on_call(EnableOverride{.kind = Kind::kSpeed, .on = false}, line_);
  feed_to(request_.bottom, sink);
  turn_spindle(request_.tap < 0, sink);
  sink.on_call(Dwell{request_.dwell_s.value_or(0.0)}, line_);
  feed_to(request_.retract, sink);
  turn_spindle(request_.tap > 0, sink);
  if (request_.feed_override) sink.on_call(EnableOverride{.kind = Kind::kFeed, .on = true}, line_);
  if (request_.speed_override) sink.on_call(EnableOverride{.kind = Kind::kSpeed, .on = true}, line_);
}

void DrillCycle::turn_spindle(bool clockwise, CanonSink& sink) noexcept {
  sink.on_call(StopSpindle{}, line_);
  sink.on_call(StartSpindle{clockwise}, line_);
}

void DrillCycle::traverse_to(double height, CanonSink& sink) noexcept {
  place_[axes_of(request_.plane).normal] = height;
  sink.on_call(StraightTraverse{place_}, line_);
}

void DrillCycle::feed_to(double height, CanonSink& sink) noexcept {
  place_[axes_of(request_.plane).normal] = height;
  sink.on_call(StraightFeed{place_}, line_);
}

}  // namespace armature::gcode
