#include "cosim/cli/kinematics/solutions_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <utility>

#include "controller/robot/axis_units.hpp"
#include "cosim/poses/pose_files.hpp"
#include "cosim/text/json.hpp"
#include "cosim/text/names.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

std::string singular_text(const IkBranch& branch) {
  std::string text;
  const auto add = [&text](bool present, std::string_view name) {
    if (present) text.append(text.empty() ? "; singular: " : ", ").append(name);
  };
  add((branch.singular & kShoulderSingular) != 0, "shoulder");
  add((branch.singular & kElbowSingular) != 0, "elbow");
  add((branch.singular & kWristSingular) != 0, "wrist");
  add((branch.singular & kFoldedSingular) != 0, "folded onto axis 2");
  return text + (branch.clamped ? "; at the reach limit" : "");
}

// The duration of a joint move at full speed, set by the slowest joint. The choice of a branch compares it.
double seconds_from(const JointAngles& previous, const JointAngles& joints, const RobotModel& model) {
  double seconds = 0;
  for (std::size_t i = 0; i < model.axis_count; ++i) {
    const double rad = std::fabs(joints[i].value() - previous[i].value());
    seconds = std::max(seconds, rad / AxisUnits{model.axes[i]}.max_speed_rad_s());
  }
  return seconds;
}

std::string verdict(const IkSolutions& solutions, std::size_t branch, const JointAngles& previous,
                    const ArmOfFile& robot) {
  const IkBranch& b = solutions.branches[branch];
  if (!b.within_limits) {
    const std::size_t joint = b.outside_axis - 1u;
    const AxisSpec& axis = robot.spec.axes.at(joint);
    return fmt::format("joint {} is outside {} .. {}", joint + 1, number_text(axis.min_deg), number_text(axis.max_deg));
  }
  const bool selected = static_cast<int>(branch) == solutions.selected;
  return fmt::format("{:.3f} s away{}", seconds_from(previous, b.joints, robot.model), selected ? ", SELECTED" : "");
}

}  // namespace

std::string solutions_table(const IkSolutions& solutions, const JointAngles& previous, const PoseFrames& frames,
                            const ArmOfFile& robot) {
  std::string text = frames.point() + " of " + printable(robot.spec.name) + ": ";
  if (solutions.count == 0) return text + "no solution, " + no_solution_text(solutions) + "\n";
  auto out = std::back_inserter(text);
  fmt::format_to(out, "{} solution{}{}\n", solutions.count, solutions.count == 1 ? "" : "s",
                 solutions.selected < 0 ? ", none of them inside the limits" : "");
  if (const double turned_deg = solutions.residual_rad * kDegPerRad; turned_deg > kMetWithinDeg) {
    fmt::format_to(out, "for the nearest orientation that five joints can reach, {:.6f} deg away\n", turned_deg);
  }
  const bool flips = robot.model.arm.family == ArmFamily::kSixR;
  fmt::format_to(out, "branch shoulder  elbow{}", flips ? "  wrist" : "");
  for (std::size_t i = 0; i < robot.spec.axis_count; ++i) fmt::format_to(out, "{:>12}_deg", fmt::format("j{}", i + 1));
  text += "   from the joints before\n";
  for (std::size_t branch = 0; branch < solutions.count; ++branch) {
    const IkBranch& b = solutions.branches[branch];
    const Configuration sides = Arm::configuration(b);
    fmt::format_to(out, "{:>6} {:>8} {:>6}", branch, side_text(sides.shoulder), side_text(sides.elbow));
    if (flips) fmt::format_to(out, " {:>6}", side_text(sides.wrist));
    for (std::size_t i = 0; i < robot.spec.axis_count; ++i) {
      text += table_number(b.joints[i].value() * kDegPerRad, 9, 16);
    }
    fmt::format_to(out, "   {}{}\n", verdict(solutions, branch, previous, robot), singular_text(b));
  }
  return text;
}

Json solutions_json(const IkSolutions& solutions, const JointAngles& previous, const ArmOfFile& robot) {
  Json json = {{"robot", robot.spec.name},
               {"selected", solutions.selected >= 0 ? Json(solutions.selected) : Json(nullptr)},
               {"no_solution", solutions.count == 0 ? Json(no_solution_text(solutions)) : Json(nullptr)},
               {"orientation_missed_deg", solutions.residual_rad * kDegPerRad},
               {"branches", Json::array()}};
  const bool flips = robot.model.arm.family == ArmFamily::kSixR;
  for (std::size_t i = 0; i < solutions.count; ++i) {
    const IkBranch& branch = solutions.branches[i];
    const Configuration sides = Arm::configuration(branch);
    Json joints_deg = Json::array();
    for (std::size_t axis = 0; axis < robot.spec.axis_count; ++axis) {
      joints_deg.push_back(branch.joints[axis].value() * kDegPerRad);
    }
    json["branches"].push_back({{"joints_deg", std::move(joints_deg)},
                                {"shoulder", side_text(sides.shoulder)},
                                {"elbow", side_text(sides.elbow)},
                                {"wrist", flips ? Json(side_text(sides.wrist)) : Json(nullptr)},
                                {"within_limits", branch.within_limits},
                                {"outside_joint", branch.within_limits ? Json(nullptr) : Json(branch.outside_axis)},
                                {"singular", singularity_names(branch.singular)},
                                {"at_reach_limit", branch.clamped},
                                {"seconds_away", seconds_from(previous, branch.joints, robot.model)}});
  }
  return json;
}

}  // namespace armature::cosim
