// A servo drive with its encoder, for tests of the controller: independent of cosim/plant.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace armature::test {

struct SimpleDrive {
  static constexpr double kAtOnce = std::numeric_limits<double>::infinity();
  double natural_rad_s = 250.0;  // kAtOnce: stands where its pulses say
  double damping = 1.0;
  double counts_per_pulse = 1.0;
  std::int64_t lose = 0;  // the next so many pulses are not seen
  bool stuck = false;     // does not move at all
  // state
  bool was_on = false;
  double reference = 0.0;    // counts
  double position = 0.0;     // counts
  double speed = 0.0;        // counts/s
  std::int64_t dropped = 0;  // net pulses lost so far

  [[nodiscard]] std::int64_t count() const { return static_cast<std::int64_t>(std::floor(position + 0.5)); }

  // Holds the position where it is switched on.
  void enable(bool on) {
    if (on && !was_on) reference = static_cast<double>(count());
    was_on = on;
  }
  // One pulse, +1 or -1.
  void step(std::int64_t direction) {
    if (was_on && lose == 0) {
      reference += static_cast<double>(direction) * counts_per_pulse;
      return;
    }
    if (was_on) --lose;
    dropped += direction;
  }
  // `h` seconds.
  void move(double h) {
    if (!was_on || stuck) {
      speed = 0.0;
    } else if (natural_rad_s == kAtOnce) {
      position = reference;
    } else {
      const double wn = natural_rad_s, friction = 2.0 * damping * wn;
      const auto accel = [&](double x, double v) { return wn * wn * (reference - x) - friction * v; };
      const double v = speed + 0.5 * h * accel(position, speed);
      const double x = position + 0.5 * h * speed;
      position += h * v;
      speed += h * accel(x, v);
    }
  }
};

}  // namespace armature::test
