// Receives what happens in the controller, on the core that caused it.
#pragma once

#include "controller/motion/telemetry.hpp"

namespace armature {

// Implementations must not call back into the controller.
class ControllerObserver {
 public:
  virtual void on_tick(const Telemetry&) noexcept = 0;            // end of each tick's computation, core 0
  virtual void on_move_started(const MoveReport&) noexcept = 0;   // core 0
  virtual void on_move_refused(const MoveRefusal&) noexcept = 0;  // core 1; core 0 for a plan that it drops
  virtual void on_io_done(const IoReport&) noexcept {}            // core 1; nothing for those without a tool
  virtual void on_fault(const Telemetry&) noexcept = 0;           // entering Fault, core 0

 protected:
  ~ControllerObserver() = default;
};

}  // namespace armature
