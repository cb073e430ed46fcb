// A conveyor belt beside the arm, as the controller knows it.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "controller/base/members.hpp"
#include "controller/base/misfit.hpp"
#include "controller/base/units.hpp"
#include "controller/cell/belt_policy_config.hpp"
#include "controller/kinematics/transform.hpp"

namespace armature {

// A camera that measures the position of the belt, or of a target in its place, instead of an encoder.
struct BeltCamera {
  Ticks period{400};  // between two samples, > 0
  Ticks dead_time{};  // from the moment that a sample shows to the tick in which it arrives, >= 0

  [[nodiscard]] const void* misfit() const noexcept {
    return first_misfit({{&period, period > Ticks{0}}, {&dead_time, dead_time >= Ticks{0}}});
  }
  ARMATURE_MEMBERS(BeltCamera, period, dead_time)
};

// The displacement of a part is the distance, in mm, that the belt has moved since the part passed the sync point.
struct ConveyorConfig {
  Transform base_T_part{};  // the frame of a part at the sync point: displacement 0
  // Unit vector in the base frame: of the belt when its counts ascend.
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
  double mm_per_count = 0.01;  // > 0
  // The arm may follow a part while its displacement is inside this window.
  double from_mm = 0.0;
  double to_mm = 0.0;             // > from_mm
  double max_speed_mm_s = 500.0;  // > 0; the arm does not follow a faster belt
  double accel_mm_s2 = 2'000.0;   // > 0; the arm takes up and leaves the velocity of the belt with this acceleration
  double speed_tolerance = 0.1;   // 0 .. 0.5; plans are checked for belts that are slower and faster by this share
  double lead_s = 0.0;            // >= 0; the drives lag behind their set-points by this time
  std::optional<BeltCamera> camera{};        // none: the belt has an encoder
  std::optional<BeltPolicyConfig> policy{};  // none: no network corrects where the belt is expected

  [[nodiscard]] const void* misfit() const noexcept {
    constexpr double kRounding = 1e-9;
    return first_misfit({{&direction, is_within(direction.squaredNorm(), 1.0 - kRounding, 1.0 + kRounding)},
                         {&mm_per_count, is_positive(mm_per_count)},
                         {&from_mm, is_finite(from_mm)},
                         {&to_mm, is_finite(to_mm) && to_mm > from_mm},
                         {&max_speed_mm_s, is_positive(max_speed_mm_s)},
                         {&accel_mm_s2, is_positive(accel_mm_s2)},
                         {&speed_tolerance, is_within(speed_tolerance, 0.0, 0.5)},
                         {&lead_s, is_at_least_0(lead_s)}});
  }
  ARMATURE_MEMBERS(ConveyorConfig, base_T_part, direction, mm_per_count, from_mm, to_mm, max_speed_mm_s, accel_mm_s2,
                   speed_tolerance, lead_s, camera, policy)
};

// The encoder of the belt, or the camera.
class BeltSensor {
 public:
  struct Sample {
    std::int64_t counts = 0;   // position in ConveyorConfig::mm_per_count
    std::uint32_t number = 0;  // another one for each sample; wraps
  };
  // The latest sample. Called once per tick.
  [[nodiscard]] virtual Sample latest() noexcept = 0;

 protected:
  BeltSensor() = default;
  BeltSensor(const BeltSensor&) = default;
  BeltSensor& operator=(const BeltSensor&) = default;
  ~BeltSensor() = default;  // never owned through this interface
};

}  // namespace armature
