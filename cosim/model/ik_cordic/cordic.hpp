// The iterative CORDIC of ik_cordic: a main lane that turns a vector onto the x axis, or an angle to 0, and slave lanes
// that follow its steps. Every pass multiplies the length of the vectors by G.
#pragma once

#include <cstdint>
#include <span>

#include "cosim/model/ik_cordic/ik_words.hpp"

namespace armature::cosim::model::ik {

struct Vector {
  std::int64_t x = 0, y = 0;  // words of any format
};

// Turns the slaves by minus the angle of `main`, and returns that angle. If `main` is zero (see the thresholds of
// ik_words.hpp), the angle is `otherwise`; `was_zero` says so.
[[nodiscard]] std::int64_t vectoring(const Vector& main, int zero_below, std::int64_t otherwise,
                                     std::span<Vector> slaves, Widths& widths, bool* was_zero = nullptr);

// Turns the slaves by minus the angle.
void rotation(std::int64_t by, std::span<Vector> slaves, Widths& widths);

}  // namespace armature::cosim::model::ik
