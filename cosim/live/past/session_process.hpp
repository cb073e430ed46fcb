// The process of a ReversibleSession: it owns the session, does what it is asked, and keeps points to which it returns.
#pragma once

#include "cosim/scenario/scenario.hpp"
#include "cosim/snapshot/message_channel.hpp"

namespace armature::cosim {

// Ends the process when the other end of the channel is closed.
[[noreturn]] void serve_session(const Scenario& scenario, MessageChannel& channel);

}  // namespace armature::cosim
