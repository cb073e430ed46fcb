// The inverse kinematics of the logic (Hu 2012): all branches of an arm from a pose in integers, in half a tick.
//
// Formats of lengths, rotations and angles, and the order of the branches: rtl/ik_cordic/README.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/hal/register_bus.hpp"
#include "controller/regs/soc_map.hpp"

namespace armature {

class IkCordic {
 public:
  static constexpr std::size_t kBranches = 8;
  static constexpr std::size_t kJoints = 6;

  explicit IkCordic(RegisterBus& bus, RegAddr base = {regs::soc::kIkCordicBase}) noexcept : bus_{bus}, base_{base} {}

  // True when the block is present and has the register map that this driver supports.
  [[nodiscard]] bool identified() noexcept;

  // Words as they are in the registers. It is enough to write them once, and what changes before each start.
  struct Geometry {
    std::int32_t a1 = 0, d1 = 0, a2 = 0, forearm = 0, a4 = 0, hand = 0, phi = 0;
  };
  void set_geometry(const Geometry& geometry) noexcept;
  // An entry of the rotation, column by column, and a coordinate of the position.
  void set_rotation(std::size_t entry, std::int32_t value) noexcept;
  void set_position(std::size_t coordinate, std::int32_t value) noexcept;
  // theta_1, theta_2 and theta_4 where they are free.
  void set_previous(const std::array<std::int32_t, 3>& angles) noexcept;

  // Solves the pose of an arm with five or six axes. No effect while busy.
  void start(bool five_axes) noexcept;
  // False from the start until the results can be read.
  [[nodiscard]] bool done() noexcept;

  // ---- results; 0 while busy
  struct Flags {
    bool shoulder_singular = false;
    std::uint8_t elbow_singular = 0, clamped = 0, folded = 0;  // bit: shoulder
    std::uint8_t wrist_singular = 0;                           // bit: 2 shoulder + elbow
  };
  [[nodiscard]] Flags flags() noexcept;
  [[nodiscard]] std::uint8_t branches() noexcept;  // bit: branch
  [[nodiscard]] std::int32_t theta(std::size_t branch, std::size_t joint) noexcept;
  [[nodiscard]] std::uint32_t cycles() noexcept;  // clocks of the last run

 private:
  RegisterBus& bus_;
  RegAddr base_;
};

}  // namespace armature
