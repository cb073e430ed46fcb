// What the operator has selected, staged and pressed, and the jogs and moves that follow from it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/cell/planning_config.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/message/command.hpp"
#include "controller/pendant/parts/coordinates.hpp"
#include "controller/pendant/parts/pressed_axes.hpp"
#include "controller/pendant/parts/staged_move.hpp"
#include "controller/pendant/protocol/frame_table.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature::pendant {

class ManualMotion {
 public:
  // References must outlive the object.
  ManualMotion(const RobotModel& robot, const Arm& arm, const PlanningConfig& planning) noexcept
      : coordinates_{robot, arm, planning} {}

  [[nodiscard]] const Coordinates& coordinates() const noexcept { return coordinates_; }
  [[nodiscard]] const PressedAxes& keys() const noexcept { return keys_; }

  // Other coordinates drop what is staged.
  void select(System system) noexcept {
    coordinates_.select(system);
    staged_.clear();
  }
  void select_user(std::uint8_t frame) noexcept {
    coordinates_.select_user(frame);
    staged_.clear();
  }
  void set_jog_limit(double share) noexcept { jog_limit_ = share; }

  void press(std::size_t axis, double share, Cycles now) noexcept { keys_.press(axis, share, now); }
  void release() noexcept { keys_.release(); }
  [[nodiscard]] Jog jog(Cycles now) const noexcept { return coordinates_.jog(keys_, jog_limit_, now); }
  // A move of one axis by a distance, from where the arm stands.
  [[nodiscard]] Command increment(std::size_t axis, std::int32_t distance,
                                  const PerAxis<Radians>& present) const noexcept {
    return coordinates_.increment(axis, distance, jog_limit_, present);
  }

  // False when no such coordinate exists.
  [[nodiscard]] bool stage_target(std::size_t parameter, std::int32_t value) noexcept {
    return staged_.stage_target(parameter, value);
  }
  void stage_option(MoveOption option, std::int32_t value) noexcept { staged_.stage_option(option, value); }
  // What is staged, and drops it. None: it is no move of so many points, or has another check value.
  [[nodiscard]] std::optional<StagedMove> take_staged(std::size_t points, std::int32_t check) noexcept {
    const StagedMove staged = std::exchange(staged_, {});
    if (!staged.complete(points, coordinates_.count()) || staged.check() != check) return std::nullopt;
    return staged;
  }

 private:
  Coordinates coordinates_;
  StagedMove staged_;
  PressedAxes keys_;
  double jog_limit_ = 0.25;  // share of the largest speeds
};

}  // namespace armature::pendant
