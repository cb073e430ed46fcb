// What the ways to move the arm have in common on core 0: each is a source of set-points while it has the arm.
//
// SourceSelector gives it the requests of its activity. They only record; advance() acts.
#pragma once

#include "controller/activity/activity_id.hpp"
#include "controller/activity/request.hpp"
#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/motion/run_control.hpp"
#include "controller/motion/set_point_source.hpp"

namespace armature {

class ActivitySource {
 public:
  // Gets the arm, which stands at `stand`.
  virtual void begin(const Request& first, const PerAxis<Radians>& stand, Ticks tick) noexcept = 0;
  virtual void feed(const Request& next) noexcept = 0;
  virtual void stop(StopKind how) noexcept = 0;
  // The set-point of the next tick. Call once per tick while the source has the arm.
  virtual SetPoint& advance(Ticks tick, const RunControl::View& control) noexcept = 0;
  // The arm stands, and its last pulse is emitted. Asked after each advance().
  [[nodiscard]] virtual bool over() noexcept = 0;
  // The arm stands at `position`, and the source does not have it.
  virtual void reset_to(const PerAxis<Radians>& position) noexcept = 0;

  // A fault begins while it has the arm: reports what is under way.
  virtual void cut_short(Ticks tick) noexcept = 0;
  // In each tick of a Fault: reports what waits.
  virtual void cancel(Ticks) noexcept {}
  // A request of its activity that comes in a Fault, or when the source is over: reports its moves.
  virtual void drop(const Request&) noexcept {}
  // In each tick, whoever has the arm.
  virtual void observe(Ticks) noexcept {}

  // Of the last advance() or reset_to().
  [[nodiscard]] const SetPoint& set_point() const noexcept { return set_point_; }

 protected:
  ActivitySource() = default;
  ActivitySource(const ActivitySource&) = delete;
  ActivitySource& operator=(const ActivitySource&) = delete;
  ~ActivitySource() = default;  // never owned through this interface

  SetPoint set_point_{};
};

}  // namespace armature
