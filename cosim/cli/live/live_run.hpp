// Advances a live session at the pace of real time and serves its page, until Ctrl-C or the end of the run.
#pragma once

#include "cosim/live/past/reversible_session.hpp"
#include "cosim/live/web_server.hpp"

namespace armature::cosim {

// `pace`: simulated time per real time, above 0. The caller has called catch_interrupts().
void run_live(ReversibleSession& session, WebServer& server, double pace);

}  // namespace armature::cosim
