#include "cosim/cli/interrupt.hpp"

#include <atomic>
#include <csignal>
#include <cstdint>
#include <ctime>

namespace armature::cosim {
namespace {

// Set by a signal handler, read by every thread that runs a scenario.
std::atomic<bool> g_interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);

std::atomic<std::int64_t> g_interrupted_at_ms{0};
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

std::int64_t now_ms() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000 + now.tv_nsec / 1'000'000;
}

void on_signal(int signal) {
  constexpr std::int64_t kSameMs = 1'000;
  if (!g_interrupted.exchange(true)) {
    g_interrupted_at_ms = now_ms();
  } else if (now_ms() - g_interrupted_at_ms >= kSameMs) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);  // when this handler has returned
  }
}

}  // namespace

void catch_interrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, on_signal);
}

bool interrupted() {
  return g_interrupted;
}

}  // namespace armature::cosim
