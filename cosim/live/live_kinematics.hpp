// The kinematics of a live page: where the hand is for joint angles, and all joint angles for a place of the hand.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "controller/kinematics/arm.hpp"
#include "cosim/robot/robot_spec.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/text/json.hpp"

namespace armature::cosim {

class LiveKinematics {
 public:
  explicit LiveKinematics(const Scenario& scenario);

  // False for a robot file without [kinematics]: the functions below must not be called.
  [[nodiscard]] bool known() const { return arm_.known(); }

  // The pose of the tool in the base: {"xyz_mm": [..], "rpy_deg": [..]}.
  [[nodiscard]] Json forward(const JointAngles& joints) const;

  struct Wish {
    Eigen::Vector3d xyz_mm = Eigen::Vector3d::Zero();
    std::optional<Eigen::Vector3d> rpy_deg{};  // none: the hand keeps its orientation, see below
    JointAngles from{};                        // the arm now: the selected solution is the nearest one
  };
  // All solutions, in the order of IkSolutions, and in words why there is none. Without an orientation a six-axis arm
  // keeps that of `from`. A five-axis arm cannot: its hand turns with the plane of the arm, about z of the base.
  [[nodiscard]] Json inverse(const Wish& wish) const;

 private:
  [[nodiscard]] Transform base_T_tool(const Wish& wish) const;
  [[nodiscard]] std::string why_not(const IkSolutions& solutions) const;

  RobotSpec robot_;
  Arm arm_;
  Transform flange_T_tool_;
  bool five_axes_;
};

}  // namespace armature::cosim
