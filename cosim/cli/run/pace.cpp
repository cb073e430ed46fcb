#include "cosim/cli/run/pace.hpp"

namespace armature::cosim {

Pace::Clock::duration Pace::wait(double simulated_s, Clock::time_point now) {
  const std::chrono::duration<double> since_start{simulated_s / factor_};
  const Clock::time_point due = start_ + std::chrono::duration_cast<Clock::duration>(since_start);
  if (now < due) return due - now;
  if (now - due > kMaxBehind) start_ += now - due - kMaxBehind;
  return Clock::duration::zero();
}

}  // namespace armature::cosim
