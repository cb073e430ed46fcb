// Slows a run down to a share of real time, for a person or a program at the serial line. No result of the simulation
// depends on it.
#pragma once

#include <chrono>

namespace armature::cosim {

class Pace {
 public:
  using Clock = std::chrono::steady_clock;

  // A run that falls behind catches up with less than this. What it is slower beyond it is not made up for, so that
  // after a slow part the arm does not move faster than its pace.
  static constexpr std::chrono::milliseconds kMaxBehind{100};

  // `factor`: simulated time per real time, above 0.
  Pace(double factor, Clock::time_point start) : factor_{factor}, start_{start} {}

  // How long to wait at the time `now`, until the simulation may pass `simulated_s`; zero if it is late.
  [[nodiscard]] Clock::duration wait(double simulated_s, Clock::time_point now);

 private:
  double factor_;
  Clock::time_point start_;  // of simulated time 0, moved by what is not made up for
};

}  // namespace armature::cosim
