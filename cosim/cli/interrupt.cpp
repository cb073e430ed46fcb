#include "cosim/cli/interrupt.hpp"

#include <atomic>
#include <csignal>

namespace armature::cosim {
namespace {

// Set by a signal handler, read by every thread that runs a scenario.
std::atomic<bool> g_interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void on_signal(int signal) {
  g_interrupted = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

bool interrupted() {
  return g_interrupted;
}

}  // namespace armature::cosim
