// The progress of a run, on one line of a terminal. It is not part of any result.
#pragma once

#include <chrono>
#include <functional>
#include <ostream>
#include <string>

namespace armature::cosim {

// `[#####-----]  50 %  0.500 of 1.000 s  x0.24  2 s left`; `wall_s` is the time since the start.
[[nodiscard]] std::string progress_line(double simulated_s, double total_s, double wall_s);

class ProgressBar {
 public:
  using Clock = std::chrono::steady_clock;

  // Writes to `out` at most ten times a second. When not `enabled` (see stderr_is_terminal) it writes nothing.
  ProgressBar(std::ostream& out, double total_s, bool enabled, std::function<Clock::time_point()> now = Clock::now);
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();  // clears the line

  void update(double simulated_s);

 private:
  std::ostream& out_;
  double total_s_;
  bool enabled_;
  std::function<Clock::time_point()> now_;
  Clock::time_point start_;
  Clock::time_point next_;
  bool drawn_ = false;
};

[[nodiscard]] bool stderr_is_terminal();

}  // namespace armature::cosim
