// A belt with its encoder, or a target of a hand with its camera: what the controller learns of it, and when.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/base/units.hpp"
#include "cosim/belt/belt_camera.hpp"
#include "cosim/belt/belt_motion.hpp"
#include "cosim/belt/conveyor_spec.hpp"

namespace armature::cosim {

class MeasuredBelt {
 public:
  struct Sample {
    std::int64_t counts = 0;
    Ticks taken{};
  };

  // `seed`: of the noise of a camera.
  MeasuredBelt(const ConveyorSpec& spec, std::uint64_t seed);

  // The sample that arrives in this tick, which begins at `now_s`. An encoder has one in each tick, taken in it. A
  // sample of a camera was taken earlier, and is not exact; none when no sample arrives.
  [[nodiscard]] std::optional<Sample> sample(Ticks tick, double now_s) const;
  [[nodiscard]] const BeltMotion& motion() const { return motion_; }

 private:
  BeltMotion motion_;
  std::optional<CameraSamples> camera_;
};

}  // namespace armature::cosim
