// Watches one pulse-and-direction pair as a drive does: counts rising edges by direction and keeps the tightest timing.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace armature::test {

class StepDirMonitor {
 public:
  static constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();

  struct Edge {
    std::int64_t time;  // cycle number of the clock edge that made it
    bool rising;
  };

  // Levels after the clock edge number `time`; call once per edge with rising `time`.
  void sample(std::int64_t time, bool step, bool dir) {
    if (dir != dir_) {
      if (step || step_) ++dir_changes_while_high;
      if (last_fall_ >= 0) min_hold = std::min(min_hold, time - last_fall_);
      last_dir_change = time;
      dir_ = dir;
    }
    if (step != step_) {
      if (last_edge_ >= 0) {
        std::int64_t& narrowest = step ? min_low : min_high;
        narrowest = std::min(narrowest, time - last_edge_);
      }
      if (step) {
        position += dir ? 1 : -1;
        ++rises;
        if (last_dir_change >= 0) min_setup = std::min(min_setup, time - last_dir_change);
      } else {
        last_fall_ = time;
      }
      last_edge_ = time;
      edges.push_back({time, step});
      step_ = step;
    }
  }

  std::int64_t position = 0;  // what the drive has counted
  std::int64_t rises = 0;
  std::int64_t dir_changes_while_high = 0;
  std::int64_t last_dir_change = -1;
  // Tightest cases so far, in cycles.
  std::int64_t min_high = kNever;
  std::int64_t min_low = kNever;
  std::int64_t min_setup = kNever;  // direction edge to rising step edge
  std::int64_t min_hold = kNever;   // falling step edge to direction edge
  std::vector<Edge> edges;          // cleared by the user

 private:
  bool step_ = false;
  bool dir_ = false;
  std::int64_t last_edge_ = -1;
  std::int64_t last_fall_ = -1;
};

}  // namespace armature::test
