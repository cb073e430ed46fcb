// The events of the controller, and the interface through which a listener is notified of them.
#pragma once

#include <variant>

#include "controller/message/fault.hpp"
#include "controller/message/homing.hpp"
#include "controller/message/io_done.hpp"
#include "controller/message/jog.hpp"
#include "controller/message/move_finished.hpp"
#include "controller/message/move_refused.hpp"
#include "controller/message/move_started.hpp"
#include "controller/message/output_switched.hpp"
#include "controller/message/part_followed.hpp"
#include "controller/message/program_noted.hpp"
#include "controller/message/stream_ended.hpp"

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
