// Moves: to positions, by position variables, and their speeds. A move is sent as a command ahead of the arm.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/language/job/execute/move_tags.hpp"
#include "controller/language/job/execute/planned_arm.hpp"
#include "controller/language/job/execute/positions.hpp"
#include "controller/language/job/state/machine_setup.hpp"
#include "controller/language/job/state/operand_reader.hpp"
#include "controller/language/job/state/step.hpp"
#include "controller/language/job/state/tools.hpp"

namespace armature::job {

class Motion {
 public:
  // References must outlive it.
  Motion(const MachineSettings& settings, Tools& tools, const Positions& positions, PlannedArm& arm) noexcept
      : settings_{settings}, tools_{tools}, positions_{positions}, arm_{arm} {}

  void reset() noexcept;

  // Instructions. False: the step says why the record is not executed.
  // MOVJ, MOVL, MOVC, MOVS and their kind.
  [[nodiscard]] bool move(Step& step, OperandReader& operands) noexcept;
  // IMOV: by a position variable. Pulses and angles are added to the joints; mm and degrees along the axes of a frame.
  [[nodiscard]] bool move_relative(Step& step, OperandReader& operands) noexcept;
  // SPEED.
  [[nodiscard]] bool set_speeds(Step& step, OperandReader& operands) noexcept;

 private:
  // A move with UNTIL, once it was sent.
  enum class Until : std::uint8_t { kNone, kMoving, kStopping };

  [[nodiscard]] bool send_move(Step& step, OperandReader& operands) noexcept;
  // The input ends a move that was sent, or its end. The program continues from where the arm stands then.
  [[nodiscard]] bool watch_until(Step& step, const OperandReader& until) noexcept;
  [[nodiscard]] bool send_joint_move(Step& step, const PositionValue& position, const MoveTags& tags) noexcept;
  // A line to the target, or an arc from the point before.
  [[nodiscard]] bool send_path_move(Step& step, const OperandReader& operands, const PositionValue& position,
                                    const MoveTags& tags) noexcept;
  // MOVS: one curve through the points of the run, sent with the second of them. The others are part of it.
  [[nodiscard]] bool send_spline(Step& step, const OperandReader& operands, const MoveTags& tags) noexcept;
  [[nodiscard]] bool send_joints_by(Step& step, const PositionValue& by, const MoveTags& tags) noexcept;
  [[nodiscard]] bool send_line_by(Step& step, OperandReader& operands, const PositionValue& by,
                                  const MoveTags& tags) noexcept;
  [[nodiscard]] bool send_path(Step& step, CartesianMove& move, const MoveTags& tags,
                               const Transform& base_T_tool) noexcept;
  // On a path the tool of the arm and the present one move alike only while they do not turn.
  [[nodiscard]] bool keeps_tool_path(Step& step, const Transform& base_T_tool) noexcept;
  // The middle of the arc to a point of a run: on the circle through the point before, this one and the next one of the
  // same arc; at the end of an arc through its last three points. None: these are on one line.
  [[nodiscard]] bool find_arc_middle(Step& step, const OperandReader& operands, const Eigen::Vector3d& end_mm,
                                     std::optional<Eigen::Vector3d>& via_mm) const noexcept;

  const MachineSettings& settings_;
  Tools& tools_;
  const Positions& positions_;
  PlannedArm& arm_;
  // Of moves that state none.
  double joint_speed_ = 0.0, speed_mm_s_ = 0.0, turn_speed_rad_s_ = 0.0;
  Until until_ = Until::kNone;
};

}  // namespace armature::job
