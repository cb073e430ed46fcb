// The PWM pin of axi_timer (rtl/axi_timer/README.md, PWM): timer 0 makes the period, timer 1 the high time.
#pragma once

namespace armature::cosim::model {

class PwmPin {
 public:
  [[nodiscard]] bool level() const { return level_; }

  // Whether an edge without an end changes nothing.
  [[nodiscard]] bool is_settled(bool active) const { return active || !level_; }

  // One edge. `first_ends`, `second_ends`: a period of timer 0, of timer 1 ends at it. `second_runs`: ENT1.
  void edge(bool active, bool first_ends, bool second_ends, bool second_runs) {
    if (!active) {
      level_ = pulse_ended_ = false;
    } else if (first_ends) {
      level_ = pulse_ended_ || !second_runs;
      pulse_ended_ = !second_runs;
    } else if (second_ends) {
      level_ = false;
      pulse_ended_ = true;
    }
  }

 private:
  bool level_ = false;
  bool pulse_ended_ = false;  // timer 1 has ended since timer 0 did, or stood when it did
};

}  // namespace armature::cosim::model
