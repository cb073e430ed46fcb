// The external relay in the servo power: it opens when the heartbeat of the logic stands still.
#pragma once

#include <cstdint>

#include "controller/base/units.hpp"
#include "cosim/plant/clock.hpp"

namespace armature::cosim {

class DropOut {
 public:
  // The relay opens `time` after the last edge of the heartbeat, at least 1 cycle.
  explicit DropOut(Cycles time) : time_{time} {}

  // Levels of the chip at cycle `now`. Returns the servo enables behind the relay, one bit per axis. The relay closes
  // when every enable is low; its time begins with the next enable.
  std::uint8_t on_pins(Cycles now, std::uint8_t servo_on, bool heartbeat) {
    const bool edge = heartbeat != heartbeat_;
    heartbeat_ = heartbeat;
    if (servo_on == 0) {
      open_ = false;
      opens_at_ = kNever;
    } else if (!open_ && (edge || opens_at_ == kNever)) {
      opens_at_ = now + time_;
    }
    return open_ ? std::uint8_t{0} : servo_on;
  }

  // The cycle at which open() must be called, unless an edge comes before it; kNever while no time runs.
  [[nodiscard]] Cycles opens_at() const { return opens_at_; }
  [[nodiscard]] bool is_open() const { return open_; }
  void open() {
    open_ = true;
    opens_at_ = kNever;
  }

 private:
  Cycles time_;
  Cycles opens_at_ = kNever;
  bool heartbeat_ = false;
  bool open_ = false;
};

}  // namespace armature::cosim
