// The samples of the camera of [conveyor.camera]: when each one arrives, and its noise.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "controller/base/units.hpp"
#include "controller/cell/conveyor_config.hpp"
#include "cosim/belt/conveyor_spec.hpp"

namespace armature::cosim {

// In whole ticks, as the controller has it. A period is one tick at least.
[[nodiscard]] BeltCamera to_camera(const BeltCameraSpec& camera);

class CameraSamples {
 public:
  CameraSamples(const BeltCameraSpec& camera, std::uint64_t seed)
      : camera_{to_camera(camera)}, hidden_s_{camera.hidden_s}, noise_mm_{camera.noise_mm}, seed_{seed} {}

  // The number of the sample that arrives in this tick; none: no sample.
  [[nodiscard]] std::optional<std::int64_t> arriving(Ticks tick) const;
  // How long before its arrival a sample was taken.
  [[nodiscard]] Ticks dead_time() const { return camera_.dead_time; }
  // Its error: nearly normal, at most six standard deviations. Independent of all others.
  [[nodiscard]] double noise_mm(std::int64_t sample) const;

 private:
  BeltCamera camera_;
  std::array<double, 2> hidden_s_;
  double noise_mm_;
  std::uint64_t seed_;
};

}  // namespace armature::cosim
