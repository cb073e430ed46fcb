// What the host decides about the controller before it starts, besides the robot and the program.
#pragma once

#include <optional>

#include "controller/base/members.hpp"
#include "controller/base/misfit.hpp"
#include "controller/base/timebase.hpp"
#include "controller/cell/conveyor_config.hpp"
#include "controller/cell/frames.hpp"
#include "controller/cell/planning_config.hpp"
#include "controller/host_memory/inverse_task.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/language/gcode/run/motion_setup.hpp"
#include "controller/language/job/state/machine_setup.hpp"
#include "controller/motion/paper_logic_port.hpp"
#include "controller/pendant/client/pendant_config.hpp"
#include "controller/trajectory/profile/synchronise.hpp"

namespace armature {

struct ControllerConfig {
  SyncRule sync = SyncRule::kFig9;
  bool feedback = true;                  // encoder feedback corrects the commanded pulses; off when `paper` is set
  std::optional<PaperEncoders> paper{};  // set: the logic is that of Vo 2021; none: the logic of this project
  Transform flange_T_tool{};             // the tool centre point and its axes
  UserFrames base_T_user{};              // element i is FrameId{i + 1}; a move in an undefined frame is refused
  double max_stretch = PlanningConfig{}.max_stretch;
  // Set: a teach pendant is on the serial line, and the drives are off until it switches them on.
  std::optional<pendant::PendantConfig> pendant{};
  std::optional<ConveyorConfig> conveyor{};  // for arms with six joints; its counts come from the host
  // Of the program of the start and of those that the pendant sends.
  job::MachineSettings job{};
  gcode::MotionSettings gcode{};
  // When the program of the start begins, at the earliest. None: when the pendant runs it.
  std::optional<Ticks> program_start{Ticks{}};
  std::optional<Ticks> program_resumes_after{};  // time after which a pause of the program ends; none: an order ends it
  bool referenced = true;  // the joint angles are 0 at the start; false: they are not known before Home
  // The set-points of paths are solved by ik_cordic; for robots with an arm, and not with `paper`.
  bool cordic = false;
  // Set: core 1 solves this pose and shows the result on the serial line. Nothing moves.
  std::optional<InverseTask> inverse{};

  [[nodiscard]] const void* misfit() const noexcept {
    constexpr Ticks kStart{};
    return first_misfit({{&max_stretch, max_stretch >= 1.0 && is_finite(max_stretch)},
                         {&gcode, is_known(gcode.frame, base_T_user)},
                         {&cordic, !cordic || !paper},
                         {&inverse, !inverse || !pendant},
                         // The logic of Vo 2021 has no network.
                         {&conveyor, !paper || !conveyor || !conveyor->policy ||
                                         conveyor->policy->where == BeltPolicyConfig::Where::kArm},
                         {&program_start, program_start.value_or(kStart) >= kStart},
                         {&program_resumes_after, program_resumes_after.value_or(kStart) >= kStart}});
  }
  ARMATURE_MEMBERS(ControllerConfig, sync, feedback, paper, flange_T_tool, base_T_user, max_stretch, pendant, conveyor,
                   job, gcode, program_start, program_resumes_after, referenced, cordic, inverse)
};

}  // namespace armature
