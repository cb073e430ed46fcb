// Checks whether the arm can follow the moves of a program, before any of them begins: reach and limits of the joints.
//
// It samples the path, so it finds what is wrong with a program, not what is wrong between two samples. The planner
// checks every set-point later, and the speeds as well.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/kinematics/ik_result.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/language/gcode/run/motion_setup.hpp"
#include "controller/language/text/fixed_text.hpp"
#include "controller/message/command.hpp"
#include "controller/trajectory/path/arm_plane.hpp"

namespace armature::gcode {

class ReachCheck {
 public:
  struct Problem {
    IkStatus status{};
    std::uint8_t axis = 0;   // kOutsideLimits: 1..6, the first one outside
    double angle_rad = 0.0;  // kOutsideLimits: of this joint
    double margin_mm = 0.0;  // kUnreachable: the largest distance of the move beyond the reach
  };

  explicit ReachCheck(const MotionSetup& setup) noexcept
      : setup_(setup), plane_(setup.cell.robot.arm, setup.cell.flange_T_tool) {}

  void begin(const JointAngles& joints) noexcept;
  // Only while !busy().
  void add(const CartesianMove& move) noexcept;
  [[nodiscard]] bool busy() const noexcept { return sample_ < samples_; }
  // Checks at most so many samples, each with one inverse kinematics.
  [[nodiscard]] std::optional<Problem> work(int max_samples) noexcept;
  // What is wrong, as a sentence.
  [[nodiscard]] FixedText<64> text_of(const Problem& problem) const noexcept;
  // The number of samples of the last work().
  [[nodiscard]] int inverses() const noexcept { return inverses_; }

 private:
  [[nodiscard]] Transform pose(double share) const noexcept;  // base_T_tool on the way

  const MotionSetup& setup_;
  ArmPlane plane_;
  JointAngles joints_{};
  std::optional<Problem> reach_problem_;  // the move leaves the reach
  Transform base_T_tool_{};               // at the start of the move
  Transform frame_T_from_{};
  CartesianMove move_{};
  int sample_ = 0;
  int samples_ = 0;
  int inverses_ = 0;
};

}  // namespace armature::gcode
