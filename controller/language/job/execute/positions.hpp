// Where the positions of a program bring the arm: its frames, its tools and the shift of SFTON.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "controller/cell/robot_cell.hpp"
#include "controller/language/job/state/operand_reader.hpp"
#include "controller/language/job/state/step.hpp"
#include "controller/language/job/state/tools.hpp"
#include "controller/language/job/state/variables.hpp"

namespace armature::job {

// Of SFTON: at most one of both.
struct Shift {
  std::optional<Transform> in_base{};  // is added to the place; its rotation is the left factor
  std::optional<Transform> in_tool{};  // the right factor

  [[nodiscard]] bool any() const noexcept { return in_base || in_tool; }
  [[nodiscard]] Transform shifted(const Transform& base_T_tool) const noexcept;
};

// Where a position brings the arm.
struct Target {
  Transform base_T_tool{};              // of the tool of the arm
  std::optional<JointAngles> joints{};  // those that the position states, if nothing shifts them
  std::uint8_t rconf = 0;               // without `joints`, and with Position::kHasRconf: the posture
};

class Positions {
 public:
  // References must outlive it. MFRAME writes the user frames of the cell.
  Positions(RobotCell& cell, const Tools& tools) noexcept : cell_{cell}, tools_{tools} {}

  void reset() noexcept { shift_ = {}; }

  [[nodiscard]] const RobotCell& cell() const noexcept { return cell_; }
  [[nodiscard]] Transform tool_at(const JointAngles& joints) const noexcept {
    return cell_.arm.forward(joints) * cell_.flange_T_tool;
  }
  [[nodiscard]] static Transform pose_of(const PositionValue& position) noexcept;
  // With the shift. What is not kNone is the alarm that the arm cannot come there.
  [[nodiscard]] Alarm find(const PositionValue& position, Target& target) const noexcept {
    return find(position, shift_, target);
  }
  // BF, RF or UF#(n) of an operand; none is the base.
  struct FrameOperand {
    Frame frame = Frame::kBase;
    double user = 0.0;
    Transform base_T_frame{};
  };
  [[nodiscard]] bool read_frame(Step& step, OperandReader& operands, FrameOperand& frame) const noexcept;

  // Instructions. False: the step says why the record is not executed.
  // SFTON: along the axes of a frame; it turns the tool about them.
  [[nodiscard]] bool set_shift(Step& step, OperandReader& operands) noexcept;
  [[nodiscard]] bool end_shift(Step& step, OperandReader& operands) noexcept;
  // MFRAME: origin, a point on x, a point in the half plane of xy with y above 0.
  [[nodiscard]] bool make_frame(Step& step, OperandReader& operands) noexcept;
  // CNVRT: the same place of the tool, in a frame, without the shift.
  [[nodiscard]] bool convert(Step& step, OperandReader& operands) const noexcept;
  // GETS. $PX000: the present pulses. $PX001: the present pose in the base. $RV: the value of RET.
  [[nodiscard]] bool get_system(Step& step, OperandReader& operands) const noexcept;

 private:
  [[nodiscard]] Alarm find(const PositionValue& position, const Shift& shift, Target& target) const noexcept;
  [[nodiscard]] JointAngles joints_of(const PositionValue& position) const noexcept;
  [[nodiscard]] PositionValue pulses_of(const JointAngles& joints) const noexcept;
  [[nodiscard]] Alarm find_frame(Frame frame, double user, Transform& base_T_frame) const noexcept;
  // RCONF of joints.
  [[nodiscard]] std::uint8_t posture_of(const JointAngles& joints) const noexcept;

  RobotCell& cell_;
  const Tools& tools_;
  Shift shift_{};
};

}  // namespace armature::job
