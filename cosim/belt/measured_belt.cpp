#include "cosim/belt/measured_belt.hpp"

#include "controller/base/timebase.hpp"

namespace armature::cosim {

MeasuredBelt::MeasuredBelt(const ConveyorSpec& spec, std::uint64_t seed) : motion_{spec} {
  if (spec.camera) camera_.emplace(*spec.camera, seed);
}

std::optional<MeasuredBelt::Sample> MeasuredBelt::sample(Ticks tick, double now_s) const {
  if (!camera_) return Sample{.counts = motion_.counts(now_s), .taken = tick};
  const std::optional<std::int64_t> number = camera_->arriving(tick);
  if (!number) return std::nullopt;
  const Ticks dead_time = camera_->dead_time();
  return Sample{.counts = motion_.counts(now_s - seconds(dead_time), camera_->noise_mm(*number)),
                .taken = tick - dead_time};
}

}  // namespace armature::cosim
