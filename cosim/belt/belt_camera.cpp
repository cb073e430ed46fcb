#include "cosim/belt/belt_camera.hpp"

#include <algorithm>
#include <cmath>

#include "controller/base/timebase.hpp"
#include "cosim/time/random.hpp"

namespace armature::cosim {
namespace {

std::int64_t ticks_of_ms(double time_ms) {
  return std::llround(time_ms * 1e-3 / kTickSeconds);
}

}  // namespace

BeltCamera to_camera(const BeltCameraSpec& camera) {
  return {.period = Ticks{std::max<std::int64_t>(1, ticks_of_ms(camera.period_ms))},
          .dead_time = Ticks{ticks_of_ms(camera.dead_time_ms)}};
}

std::optional<std::int64_t> CameraSamples::arriving(Ticks tick) const {
  const Ticks taken = tick - camera_.dead_time;
  const std::int64_t period = camera_.period.value();
  if (taken < Ticks{} || taken.value() % period != 0) return std::nullopt;
  const double taken_s = seconds(taken);
  if (taken_s >= hidden_s_[0] && taken_s < hidden_s_[1]) return std::nullopt;
  return taken.value() / period;
}

// A sum of 12 uniform numbers has the variance 1.
double CameraSamples::noise_mm(std::int64_t sample) const {
  constexpr int kSummands = 12;
  Random random{Random{seed_}.next() ^ static_cast<std::uint64_t>(sample)};
  double sum = -0.5 * kSummands;
  for (int i = 0; i < kSummands; ++i) sum += random.unit();
  return noise_mm_ * sum;
}

}  // namespace armature::cosim
