#include "cosim/cli/run/interrupt.hpp"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <ctime>

namespace armature::cosim {
namespace {

// Time of the first signal. 0: there was none. Set by a signal handler, read by every thread that runs a scenario.
std::atomic<std::int64_t> g_first_ms{0};
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

std::int64_t now_ms() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000 + now.tv_nsec / 1'000'000;
}

void on_signal(int signal) {
  constexpr std::int64_t kSameMs = 1'000;
  const std::int64_t now = std::max<std::int64_t>(1, now_ms());
  std::int64_t first = 0;  // with one exchange, since another signal may interrupt this handler
  if (!g_first_ms.compare_exchange_strong(first, now) && now - first >= kSameMs) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);  // when this handler has returned
  }
}

}  // namespace

void catch_interrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, on_signal);
}

bool interrupted() {
  return g_first_ms != 0;
}

}  // namespace armature::cosim
