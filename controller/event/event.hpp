// The events of the controller, and the interface through which a listener is notified of them.
#pragma once

#include <variant>

#include "controller/event/fault.hpp"
#include "controller/event/homing.hpp"
#include "controller/event/io_done.hpp"
#include "controller/event/jog.hpp"
#include "controller/event/move_finished.hpp"
#include "controller/event/move_refused.hpp"
#include "controller/event/move_started.hpp"
#include "controller/event/output_switched.hpp"
#include "controller/event/part_followed.hpp"
#include "controller/event/program_noted.hpp"
#include "controller/event/stream_ended.hpp"

namespace armature {

using Event = std::variant<MoveStarted, MoveFinished, MoveRefused, IoDone, Faulted, FaultCleared, JogStarted, JogEnded,
                           StreamEnded, OutputSwitched, PartFollowed, HomingStarted, HomingEnded, ProgramNoted>;

class EventListener {
 public:
  // Called on the core that caused the event. Implementations must not call back into the sender of the event.
  virtual void on_event(const Event& event) noexcept = 0;

 protected:
  ~EventListener() = default;  // never owned through this interface
};

}  // namespace armature
