// What ik_cordic computes, bit for bit: all branches of the inverse kinematics of a six-axis arm (Vo 2021) or of a
// five-axis arm (Hu 2012), in integers. The equations are those of controller/kinematics;
// rtl/ik_cordic/README.md describes the arithmetic.
#pragma once

#include <array>
#include <cstdint>

namespace armature::cosim::model::ik {

inline constexpr std::size_t kBranches = 8;
inline constexpr std::size_t kJoints = 6;

// What the registers of the block contain at the start. Lengths and entries of the rotation: see ik_words.hpp.
struct Job {
  bool five_r = false;
  std::array<std::int32_t, 9> rotation{};  // columns: n_x n_y n_z o_x o_y o_z a_x a_y a_z
  std::array<std::int32_t, 3> position{};
  // kSixR: a1, d1, a2, k = hypot(a3, d4), unused, d6, phi = atan2(d4, a3). kFiveR: a1, 0, a2, a3, a4, d5, 0.
  std::int32_t a1 = 0, base = 0;
  std::uint32_t upper = 0, fore = 0;  // below 32 each, their sum as well
  std::int32_t a4 = 0, hand = 0;
  std::int32_t phi = 0;
  std::int32_t previous1 = 0, previous2 = 0, previous4 = 0;  // angles where one is free
};

// Branch 4 * shoulder + 2 * elbow + flip, 0 for + and 1 for - of IkSolutions. kFiveR has no flip: only even branches.
struct Solved {
  // Where flip - is not valid it is the flip of flip +, which is 0 where that is not valid.
  std::array<std::array<std::int32_t, kJoints>, kBranches> theta{};
  std::uint8_t valid = 0;  // bit: branch
  // Bits of a shoulder: its branches are at the reach limit; beyond it, by rounding; joint 4 (kFiveR) or the wrist
  // centre is on axis 2, and theta_2 is the previous one.
  std::uint8_t elbow_singular = 0, clamped = 0, folded = 0;
  bool shoulder_singular = false;   // theta_1 is the previous one (front), or half a turn away (back)
  std::uint8_t wrist_singular = 0;  // bit 2 * shoulder + elbow: theta_4 is the previous one, flip + stands for both
  int clocks = 0;                   // that the block is busy
  bool exceeded = false;            // a value did not fit its word; excluded for every job with the stated ranges

  [[nodiscard]] bool operator==(const Solved&) const = default;
};

[[nodiscard]] Solved solve(const Job& job);

// What the block has before its first run.
[[nodiscard]] Solved unsolved();

}  // namespace armature::cosim::model::ik
