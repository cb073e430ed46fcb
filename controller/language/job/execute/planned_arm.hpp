// What is known of the arm at the end of the commands that were sent, and the joints with which it reaches a target
// from there.
//
// The end of a path is known as a pose, and its joints only when the arm stands there. So nothing here waits for them
// where they do not decide.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/language/job/execute/positions.hpp"
#include "controller/language/job/state/step.hpp"

namespace armature::job {

class PlannedArm {
 public:
  // The reference must outlive it.
  explicit PlannedArm(const Positions& positions) noexcept : positions_{positions} {}

  void reset() noexcept {
    forget();
    finish_record();
  }
  // It stands wherever it stands when all is over.
  void forget() noexcept {
    joints_.reset();
    base_T_tool_.reset();
  }
  // What a command was sent for. With joints the pose is that of them.
  void set(const std::optional<JointAngles>& joints, const Transform& base_T_tool) noexcept;
  void finish_record() noexcept { needs_joints_ = false; }

  // False: the step waits until the arm stands. Then joints() or base_T_tool() has a value.
  [[nodiscard]] bool know_joints(Step& step) noexcept;
  [[nodiscard]] bool know_pose(Step& step) noexcept;
  [[nodiscard]] const std::optional<JointAngles>& joints() const noexcept { return joints_; }
  [[nodiscard]] const std::optional<Transform>& base_T_tool() const noexcept { return base_T_tool_; }

  // What solve() finds where a posture is stated. A path decides itself about whole turns, so it needs the sides only.
  enum class Solve : std::uint8_t { kSides, kJoints };
  // The joints of the posture that a target states, if it states one. False: the step says why there are none.
  [[nodiscard]] bool solve(Step& step, Solve wanted, Target& target) noexcept;
  // The joints of a joint move. Without them the arm reaches the pose with those nearest to where it will be.
  [[nodiscard]] bool solve_joint_move(Step& step, Target& target) noexcept;

 private:
  const Positions& positions_;
  std::optional<JointAngles> joints_{};
  std::optional<Transform> base_T_tool_{};
  bool needs_joints_ = false;  // the record that is executed waits for the joints before it
};

}  // namespace armature::job
