// A controller whose arm starts at joint angles that it does not know, with switches and index pulses.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/base/axes.hpp"
#include "controller/message/command.hpp"
#include "tests/controller/support/controller_rig.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature::test {

// The arm of Figure 9: its index comes every 7.2 degrees.
inline constexpr double kIndexDeg = 7.2;
inline constexpr double kCountDeg = 7.2e-4;

// Joints of -40 to 40 degrees. The home switch is searched in the negative direction; its edge is -15.5, and the index
// behind it -14.4 degrees. Axes 1 and 2 begin together, then 3, and so on.
inline RobotModel homing_robot(double gear = 50.0) {
  RobotModel robot = paper_robot();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    AxisModel& model = robot.axes[axis];
    model.gear_ratio = gear;
    model.min_rad = -40.0 * kDeg;
    model.max_rad = 40.0 * kDeg;
    model.homing = HomingModel{.order = static_cast<std::uint8_t>(axis < 2 ? 1 : axis),
                               .direction = -1.0,
                               .search_rad_s = 40.0 * kDeg,
                               .latch_rad_s = 10.0 * kDeg,
                               .index_rad = -14.4 * kDeg,
                               .home_rad = -10.0 * kDeg};
  }
  return robot;
}

class HomingRig {
 public:
  static constexpr std::int64_t kSecond = 20'000;  // ticks

  struct Zone {
    double from_deg = 0.0, to_deg = 0.0;
  };
  struct World {
    double start_deg = 0.0;
    Zone home{-20.0, -15.5};
    Zone limits{-42.0, 42.0};  // a limit switch is active outside
    double index_offset_deg = 0.0;
    bool has_index = true;
  };

  explicit HomingRig(const RobotModel& model = homing_robot()) : rig{model, ControllerConfig{.referenced = false}} {
    rig.on_each_trigger = [this] { show(); };
  }

  // Homes the axes of the mask from this angle, to the nearest count: encoders count from the start on.
  void home(double start_deg, std::uint8_t axes = 1, std::int64_t ticks = 3 * kSecond) {
    for (World& world : worlds) world.start_deg = std::round(start_deg / kCountDeg) * kCountDeg;
    rig.submit_at(10, Home{.axes = axes, .tag = 7});
    rig.run(ticks);
  }

  // The joint angle of the axis, whatever the controller takes it for.
  [[nodiscard]] double joint_deg(std::size_t axis) const {
    return worlds[axis].start_deg + static_cast<double>(rig.logic.count(axis)) * deg_per_count(axis);
  }
  [[nodiscard]] const HomingEnded* end(std::size_t axis) const {
    for (const HomingEnded& end : rig.homings_ended) {
      if (end.axis == axis + 1) return &end;
    }
    return nullptr;
  }
  // Of the axis, or kFault when it has none.
  [[nodiscard]] HomingEnd how(std::size_t axis) const {
    return end(axis) == nullptr ? HomingEnd::kFault : end(axis)->how;
  }

  ControllerRig rig;
  PerAxis<World> worlds{};

 private:
  [[nodiscard]] double deg_per_count(std::size_t axis) const {
    return rig.robot.axes[axis].gear_ratio < 0.0 ? -kCountDeg : kCountDeg;
  }

  void show() {
    std::uint8_t home = 0, positive = 0, negative = 0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const World& world = worlds[axis];
      const double deg = joint_deg(axis);
      const auto bit = static_cast<std::uint8_t>(1u << axis);
      if (deg >= world.home.from_deg && deg <= world.home.to_deg) home |= bit;
      if (deg <= world.limits.from_deg) negative |= bit;
      if (deg >= world.limits.to_deg) positive |= bit;
      show_index(axis, deg);
    }
    rig.logic.pins.home = home;
    rig.logic.pins.limit_pos = positive;
    rig.logic.pins.limit_neg = negative;
  }

  // The last index that the axis has passed since the trigger before.
  void show_index(std::size_t axis, double deg) {
    const World& world = worlds[axis];
    const double before = turns_[axis].value_or(std::floor((deg - world.index_offset_deg) / kIndexDeg));
    const double now = std::floor((deg - world.index_offset_deg) / kIndexDeg);
    turns_[axis] = now;
    if (now == before || !world.has_index) return;
    const double index_deg = std::fmax(now, before) * kIndexDeg + world.index_offset_deg;
    rig.logic.pass_index(axis, std::lround((index_deg - world.start_deg) / deg_per_count(axis)));
  }

  PerAxis<std::optional<double>> turns_{};
};

}  // namespace armature::test
