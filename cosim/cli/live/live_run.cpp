#include "cosim/cli/live/live_run.hpp"

#include <algorithm>
#include <chrono>

#include "cosim/cli/run/interrupt.hpp"
#include "cosim/cli/run/pace.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

using Clock = Pace::Clock;

constexpr Clock::duration kFrame = std::chrono::microseconds{16'667};  // 60 Hz
constexpr Cycles kLiveSlice{100'000};                                  // 2 ms: what a page presses waits so long
constexpr Clock::duration kFarewell = std::chrono::milliseconds{100};

// Simulated time per real time over the last second.
class Factor {
 public:
  Factor(Clock::time_point now, double simulated_s) : since_{now}, simulated_since_s_{simulated_s} {}

  double update(Clock::time_point now, double simulated_s) {
    constexpr std::chrono::duration<double> kSpan{1.0};
    const std::chrono::duration<double> real = now - since_;
    if (real >= kSpan) {
      factor_ = (simulated_s - simulated_since_s_) / real.count();
      since_ = now;
      simulated_since_s_ = simulated_s;
    }
    return factor_;
  }

 private:
  Clock::time_point since_;
  double simulated_since_s_;
  double factor_ = 0;
};

// Real time and simulated time together, from a moment on.
struct Times {
  Times(double pace_factor, Clock::time_point now, double simulated_s)
      : pace{pace_factor, now - std::chrono::duration_cast<Clock::duration>(
                                    std::chrono::duration<double>{simulated_s / pace_factor})},
        factor{now, simulated_s} {}

  Pace pace;
  Factor factor;
};

Clock::duration time_to_wait(const ReversibleSession& session, Pace& pace, Clock::time_point now) {
  if (session.is_on_the_way()) return Clock::duration::zero();
  return session.is_looking() ? kFrame : pace.wait(to_seconds(session.now()), now);
}

}  // namespace

void run_live(ReversibleSession& session, WebServer& server, double pace_factor) {
  Clock::time_point next_frame = Clock::now();
  Times times{pace_factor, next_frame, 0};
  int jumps = 0;
  bool over = false;
  while (!over && !interrupted()) {
    Clock::time_point now = Clock::now();
    if (jumps != session.jumps()) times = Times{pace_factor, now, to_seconds(session.now())};
    jumps = session.jumps();
    Clock::duration wait = time_to_wait(session, times.pace, now);
    if (wait == Clock::duration::zero()) {
      over = !session.advance(session.now() + kLiveSlice);
      now = Clock::now();
    }
    if (now >= next_frame || over) {
      const double lately = times.factor.update(now, to_seconds(session.now()));
      if (server.has_page()) server.offer(session.state(lately));
      next_frame = std::max(next_frame + kFrame, now);
    }
    server.handle(std::min(wait, std::max(next_frame - now, Clock::duration::zero())));
  }
  server.handle(kFarewell);
}

}  // namespace armature::cosim
