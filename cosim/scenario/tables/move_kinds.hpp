// What each kind of command says about itself. The loader, KEYS.md, the schema and the log follow.
// A kind of CommandKind without an entry does not compile.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "controller/trajectory/path/segment_request.hpp"
#include "cosim/scenario/keys/key.hpp"
#include "cosim/scenario/move_spec.hpp"
#include "cosim/scenario/tables/jog_kind.hpp"
#include "cosim/scenario/tables/move_entry.hpp"
#include "cosim/scenario/tables/path_keys.hpp"
#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {

template <>
[[nodiscard]] inline const MoveEntry<JointSpec>& move_entry<JointSpec>() {
  static const MoveEntry<JointSpec> kEntry = [&] {
    MoveEntry<JointSpec> entry{
        .name = "joint",
        .text = "moves the joints",
        .queued = true,
        .keys =
            {key("target_deg", &JointSpec::target_deg, target_angle(), "Joint angles at the end of the move.")
                 .required(),
             part(&JointSpec::pose, xyz_key("Position of the tool centre point at the end of the move. The tool does "
                                            "not move on a straight line to it.")
                                        .replaces("target_deg")),
             part(&JointSpec::pose, rpy_key()), part(&JointSpec::pose, pose_frame_key()),
             key("speed_percent", &JointSpec::speed_percent, between(kMinPercent, 100, "percent"),
                 "Speed of the joints as a share of their speed limits."),
             key("accel_percent", &JointSpec::accel_percent, between(kMinPercent, 100, "percent"),
                 "Acceleration of the joints as a share of their acceleration limits."),
             key("profile", &JointSpec::profile, profile_names(),
                 "Shape of the speed over time. `scurve` limits the jerk and needs `max_jerk_deg_s3` of every axis "
                 "of the robot.")
                 .checked(
                     [](JointSpec& move, const KeyContext& context) { return lacking_jerk(move.profile, context); }),
             key("when", &JointSpec::when, one_of({"in_order", "now"}),
                 "`in_order`: the move begins after the moves before it. `now`: it begins at once, also in motion, and "
                 "replaces all moves before it.")
                 .only(beside("target_deg")),
             key("blend_deg", &JointSpec::blend_deg, between(0, kMaxAngleDeg, "deg"),
                 "When another `joint` move or a path follows, the joints pass the target without a stop. This is the "
                 "largest deviation of any joint from the target there. At 0 they stop exactly at the target."),
             key("blend_percent", &JointSpec::blend_percent, between(0, 100, "percent"),
                 "The same deviation as a share. 100 % is half of a joint's way in this move or in the next one, "
                 "whichever is shorter. The joint is the one that moves farthest.")
                 .replaces("blend_deg")},
    };
    append_pose_keys(entry.keys, &JointSpec::pose, configuration_keys());
    return entry;
  }();
  return kEntry;
}

template <>
[[nodiscard]] inline const MoveEntry<LineSpec>& move_entry<LineSpec>() {
  static const MoveEntry<LineSpec> kEntry{
      .name = "line",
      .text = "moves the tool on a straight line",
      .queued = true,
      .keys = keys_of_path<LineSpec>(),
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const MoveEntry<ArcSpec>& move_entry<ArcSpec>() {
  static const MoveEntry<ArcSpec> kEntry{
      .name = "arc",
      .text = "moves the tool on an arc",
      .queued = true,
      .keys = keys_of_path_via<ArcSpec>(),
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const MoveEntry<CircleSpec>& move_entry<CircleSpec>() {
  static const MoveEntry<CircleSpec> kEntry{
      .name = "circle",
      .text = "moves the tool once around a circle",
      .queued = true,
      .keys = keys_of_path_via<CircleSpec>(),
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const MoveEntry<ArcAboutSpec>& move_entry<ArcAboutSpec>() {
  constexpr std::string_view kPlace = "center_mm";
  constexpr double kMaxTurnsDeg = 360 * kMostRevolutions;
  constexpr auto kCheckAxis = [](ArcAboutSpec& move, const KeyContext&) -> std::string {
    return move.axis == std::array<double, 3>{} ? "expected a direction, found 0, 0, 0" : "";
  };
  constexpr auto kCheckAngle = [](ArcAboutSpec& move, const KeyContext&) -> std::string {
    return move.angle_deg == 0 ? "expected an angle other than 0" : "";
  };
  static const MoveEntry<ArcAboutSpec> kEntry = [&] {
    MoveEntry<ArcAboutSpec> entry{
        .name = "arc_about",
        .text = "moves the tool around an axis by an angle: on an arc, a circle or, with `advance_mm`, a helix",
        .queued = true,
        .keys = {key(kPlace, &ArcAboutSpec::center_mm, target_place(),
                     "A point of the axis, for example the centre of the circle. The circle passes the start of the "
                     "move, and its plane is at a right angle to the axis.")
                     .required()
                     .needs(Needs::kKinematics),
                 key("axis", &ArcAboutSpec::axis, target_place(),
                     "Direction of the axis in the frame, of any length: [0, 0, 1] is its z axis.")
                     .checked(kCheckAxis),
                 key("angle_deg", &ArcAboutSpec::angle_deg, between(-kMaxTurnsDeg, kMaxTurnsDeg, "deg"),
                     "Angle around the axis, right-handed where it is above 0. More than 360 means several turns.")
                     .checked(kCheckAngle),
                 key("advance_mm", &ArcAboutSpec::advance_mm, target_place(),
                     "Distance along the axis during the whole move.")}};
    for (Key<ArcAboutSpec>& key : keys_of_path_from<ArcAboutSpec>(kPlace)) entry.keys.push_back(std::move(key));
    return entry;
  }();
  return kEntry;
}

template <>
[[nodiscard]] inline const MoveEntry<SplineSpec>& move_entry<SplineSpec>() {
  static const MoveEntry<SplineSpec> kEntry = [] {
    MoveEntry<SplineSpec> entry{.name = "spline",
                                .text = "moves the tool on a smooth curve through points",
                                .queued = true,
                                .keys = keys_of_path<SplineSpec>()};
    Rule rule = target_place();
    rule.most_rows = ThroughPoints::kMax;
    entry.keys.push_back(
        key("through_mm", &SplineSpec::through_mm, rule,
            "Points that the tool centre point passes exactly between its start and `xyz_mm`, in this order. The curve "
            "is a cubic spline over the sum of the distances between the points, without curvature at both ends. A "
            "chain has at most 4 splines: the tool stops before the fifth.")
            .required()
            .checked([](SplineSpec& spline, const KeyContext&) -> std::string {
              if (spline.path.pose.frame == kConveyorFrame.index) return "a spline cannot move with the conveyor";
              const bool tangent = spline.path.orientation == CartesianMove::Orientation::kTangent;
              return tangent ? "a spline has no orientation \"tangent\"" : "";
            }));
    return entry;
  }();
  return kEntry;
}

template <>
[[nodiscard]] inline const MoveEntry<DwellSpec>& move_entry<DwellSpec>() {
  static const MoveEntry<DwellSpec> kEntry{
      .name = "dwell",
      .text = "stands still between two moves",
      .queued = true,
      .keys = {key("duration_s", &DwellSpec::duration_s, above(0, kMaxDurationS, "s"),
                   "Time from the end of the move before to the start of the next one, in whole ticks of 50 us. An "
                   "override has no effect on it.")
                   .required()},
      .details = [](const DwellSpec& dwell) { return fmt::format(" {} s", number_text(dwell.duration_s)); }};
  return kEntry;
}

template <>
[[nodiscard]] inline const MoveEntry<PolylineSpec>& move_entry<PolylineSpec>() {
  static const MoveEntry<PolylineSpec> kEntry = [] {
    MoveEntry<PolylineSpec> entry{
        .name = "polyline",
        .text = "moves the tool on straight lines through the points of a file, and keeps its orientation",
        .queued = true,
        .keys = {key("points_file", &PolylineSpec::points_file, anything(),
                     "CSV file with the points, in the folder of the scenario: a line `x_mm,y_mm,z_mm`, then a line "
                     "for each point, at most 100000.")
                     .required()
                     .needs(Needs::kKinematics)}};
    for (Key<PathSpec>& key : polyline_keys()) entry.keys.push_back(part(&PolylineSpec::path, std::move(key)));
    return entry;
  }();
  return kEntry;
}

template <>
[[nodiscard]] inline const MoveEntry<HoldSpec>& move_entry<HoldSpec>() {
  static const MoveEntry<HoldSpec> kEntry{.name = "hold", .text = "brakes on the path and waits there"};
  return kEntry;
}

template <>
[[nodiscard]] inline const MoveEntry<ResumeSpec>& move_entry<ResumeSpec>() {
  static const MoveEntry<ResumeSpec> kEntry{.name = "resume", .text = "continues after a hold"};
  return kEntry;
}

template <>
[[nodiscard]] inline const MoveEntry<OverrideSpec>& move_entry<OverrideSpec>() {
  constexpr double kMinOverride = 1;
  static const MoveEntry<OverrideSpec> kEntry{
      .name = "override",
      .text = "sets the speed of all moves from then on",
      .keys = {key("speed_percent", &OverrideSpec::speed_percent, between(kMinOverride, 100, "percent"),
                   "Speed of all moves from then on, as a share of their own speed.")
                   .required()},
      .details = [](const OverrideSpec& move) { return fmt::format(" {} %", number_text(move.speed_percent)); },
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const MoveEntry<StopSpec>& move_entry<StopSpec>() {
  static const MoveEntry<StopSpec> kEntry{
      .name = "stop",
      .text = "brakes on the path and drops all moves",
      .keys = {key("mode", &StopSpec::mode, one_of({"quick", "soft"}),
                   "`quick`: with the full acceleration of the joints, and with any jerk. `soft`: within the limits of "
                   "the move, as a `hold`. In both the drives stay enabled (category 2 of IEC 60204-1).")},
      .details = [](const StopSpec& stop) { return stop.mode == "quick" ? std::string{} : " " + stop.mode; },
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const MoveEntry<ClearFaultSpec>& move_entry<ClearFaultSpec>() {
  static const MoveEntry<ClearFaultSpec> kEntry{.name = "clear_fault",
                                                .text = "leaves the state Fault when the cause of the fault is gone"};
  return kEntry;
}

template <>
[[nodiscard]] inline const MoveEntry<HomeSpec>& move_entry<HomeSpec>() {
  constexpr auto kCheckAxes = [](HomeSpec& home, const KeyContext& context) -> std::string {
    const RobotSpec* robot = context.robot.spec;
    if (robot == nullptr) return {};
    for (const std::int64_t axis : home.axes) {
      const auto index = static_cast<std::size_t>(axis - 1);
      if (index >= robot->axis_count) return fmt::format("the robot has {} axes, found {}", robot->axis_count, axis);
      if (!robot->axes[index].homing)
        return fmt::format("axis {} has no [axis.homing] in {}", axis, context.robot.file);
    }
    return {};
  };
  static const MoveEntry<HomeSpec> kEntry{
      .name = "home",
      .text =
          "finds the joint angles by the home switches, when no other move runs or waits, and moves to the home "
          "positions",
      .keys = {key("axes", &HomeSpec::axes, between(1, kAxes), "Numbers of the axes.")
                   .without("all axes")
                   .checked(kCheckAxes)},
  };
  return kEntry;
}

// The keys of a command for a pin of the tool.
template <class Kind>
[[nodiscard]] std::vector<Key<Kind>> pin_keys() {
  return {pin_key<Kind>("Number of the output or input."),
          level_key<Kind>("Level of the output, or level that the wait ends at: 0 is low, 1 is high.")};
}

template <>
[[nodiscard]] inline const MoveEntry<DoutSpec>& move_entry<DoutSpec>() {
  static const MoveEntry<DoutSpec> kEntry{
      .name = "dout", .text = "switches an output of the tool", .queued = true, .keys = pin_keys<DoutSpec>()};
  return kEntry;
}

template <>
[[nodiscard]] inline const MoveEntry<WaitDinSpec>& move_entry<WaitDinSpec>() {
  constexpr double kMaxTimeoutS = 86'400;
  static const MoveEntry<WaitDinSpec> kEntry = [] {
    MoveEntry<WaitDinSpec> entry{.name = "wait_din",
                                 .text = "delays the commands after it until an input has the given level",
                                 .queued = true,
                                 .keys = pin_keys<WaitDinSpec>()};
    entry.keys.push_back(
        key("timeout_s", &WaitDinSpec::timeout_s, above(0, kMaxTimeoutS, "s"),
            "Longest time of the wait. When it has passed, the controller drops the wait and all moves after it.")
            .without("no limit"));
    return entry;
  }();
  return kEntry;
}

}  // namespace armature::cosim
