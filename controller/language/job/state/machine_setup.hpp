// What the machine knows of the robot, the cell and the settings of a user.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/base/members.hpp"
#include "controller/base/misfit.hpp"
#include "controller/cell/robot_cell.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/language/job/memory/switches.hpp"
#include "controller/language/job/state/pin_levels.hpp"

namespace armature::job {

inline constexpr std::size_t kToolNumbers = 64;  // 0 to 63

// The settings of a user: [job] of a scenario.
struct MachineSettings {
  // The radius of the rounded corner of a path for PL=0..8. Joint moves pass at PL eighths of half their way.
  std::array<double, 9> pl_radius_mm{0.0, 12.5, 25.0, 50.0, 100.0, 150.0, 200.0, 250.0, 300.0};
  // Of moves without a speed, before the first SPEED.
  double joint_speed = 0.1;  // share of the limits: 10 %
  double speed_mm_s = 100.0;
  double turn_speed_rad_s = 1.5707963267948966;
  // ACC=100.
  double accel_mm_s2 = 1'000.0;
  double turn_accel_rad_s2 = 15.707963267948966;
  // Outputs that instructions switch, by Device; 0: none, and the instruction is an alarm.
  std::array<std::uint8_t, kDevices> device_pin{};
  [[nodiscard]] std::uint8_t pin_of(Device device) const noexcept {
    return device_pin[static_cast<std::size_t>(device)];
  }
  // Tools besides that of the arm, by number.
  std::array<std::optional<Transform>, kToolNumbers> flange_T_tool{};

  [[nodiscard]] constexpr const void* misfit() const noexcept {
    const auto is_pin = [](std::uint8_t pin) { return pin <= PinLevels::kPins; };
    return first_misfit({{&pl_radius_mm, std::all_of(pl_radius_mm.begin(), pl_radius_mm.end(), is_at_least_0)},
                         {&joint_speed, is_positive(joint_speed) && joint_speed <= 1.0},
                         {&speed_mm_s, is_positive(speed_mm_s)},
                         {&turn_speed_rad_s, is_positive(turn_speed_rad_s)},
                         {&accel_mm_s2, is_positive(accel_mm_s2)},
                         {&turn_accel_rad_s2, is_positive(turn_accel_rad_s2)},
                         {&device_pin, std::all_of(device_pin.begin(), device_pin.end(), is_pin)}});
  }
  ARMATURE_MEMBERS(MachineSettings, pl_radius_mm, joint_speed, speed_mm_s, turn_speed_rad_s, accel_mm_s2,
                   turn_accel_rad_s2, device_pin, flange_T_tool)
};

struct MachineSetup {
  RobotCell cell;
  MachineSettings settings{};
};

}  // namespace armature::job
