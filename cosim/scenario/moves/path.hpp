// What all paths of the tool have in common: the types `line`, `arc`, `circle`, `arc_about`, `spline` and `polyline` of
// [[move]].
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "controller/base/angle_units.hpp"
#include "controller/message/command.hpp"
#include "controller/trajectory/path/segment_request.hpp"
#include "cosim/scenario/moves/entry.hpp"
#include "cosim/scenario/moves/pose.hpp"

namespace armature::cosim {

// What all paths of the tool have.
struct PathSpec {
  PoseTarget pose{};  // at the end; of a circle the third point
  ProfileKind profile = ProfileKind::kTrapezoid;
  double speed_mm_s = 100, accel_mm_s2 = 1000, jerk_mm_s3 = 0;
  double turn_speed_deg_s = 90, turn_accel_deg_s2 = 900, turn_jerk_deg_s3 = 0;
  double accel_percent = 100;  // of all accelerations
  double blend_mm = 0;
  bool exact_stop = false;
  CartesianMove::Orientation orientation = CartesianMove::Orientation::kSteady;
  AtSingularity at_singularity = AtSingularity::kSlow;
  double orientation_tolerance_deg = 5;
};

inline constexpr double kMaxBlendMm = 10'000;
inline constexpr double kMaxToleranceDeg = 30;  // less than CartesianMove::kMaxTolerance_rad

[[nodiscard]] inline Key<PathSpec> jerk_key(std::string_view name, double PathSpec::*member, std::string_view unit,
                                            std::string_view text) {
  return key(name, member, above(0, kMaxJerk, unit), text).required().only(when("profile", {"scurve"}));
}

// The keys of its motion: without its end.
[[nodiscard]] inline Keys<PathSpec> path_motion_keys() {
  return {
      profile_key(&PathSpec::profile, "Shape of the speed over time. `scurve` limits the jerk."),
      key("speed_mm_s", &PathSpec::speed_mm_s, above(0, kMaxSpeed, "mm/s"), "Largest speed of the tool centre point."),
      key("accel_mm_s2", &PathSpec::accel_mm_s2, above(0, kMaxAccel, "mm/s^2"),
          "Largest acceleration of the tool centre point."),
      jerk_key("jerk_mm_s3", &PathSpec::jerk_mm_s3, "mm/s^3", "Largest jerk of the tool centre point."),
      key("turn_speed_deg_s", &PathSpec::turn_speed_deg_s, above(0, kMaxSpeed, "deg/s"),
          "Largest angular speed of the tool."),
      key("turn_accel_deg_s2", &PathSpec::turn_accel_deg_s2, above(0, kMaxAccel, "deg/s^2"),
          "Largest angular acceleration of the tool."),
      jerk_key("turn_jerk_deg_s3", &PathSpec::turn_jerk_deg_s3, "deg/s^3", "Largest angular jerk of the tool."),
      key("accel_percent", &PathSpec::accel_percent, between(kMinPercent, 100, "percent"),
          "Share of all limits of acceleration: of `accel_mm_s2`, of `turn_accel_deg_s2`, and of the joints."),
      key("blend_mm", &PathSpec::blend_mm, between(0, kMaxBlendMm, "mm"),
          "Largest distance by which the rounded corner to the next path or `joint` move may leave the path. At 0 the "
          "tool stops exactly in the corner. In a corner with a `joint` move only the limits of the joints apply: the "
          "tool "
          "may be much faster there than `speed_mm_s`."),
      key("exact_stop", &PathSpec::exact_stop, anything(),
          "`true`: the tool stops at the end of the path, even if the next path continues in the same direction.")
          .checked([](PathSpec& path, const KeyContext&) -> std::string {
            return path.exact_stop && path.blend_mm > 0 ? "a path with `blend_mm` above 0 does not stop" : "";
          }),
      named_key(
          "orientation", &PathSpec::orientation,
          "How the tool turns. `steady` turns to `rpy_deg` about one axis. `fixed` keeps the orientation. `tangent` "
          "turns with the direction of the path, on arcs and circles. `slerp` turns as `steady`, on a five-axis "
          "arm also with a tilted hand (see below).")
          .checked([](PathSpec& path, const KeyContext&) -> std::string {
            using enum CartesianMove::Orientation;
            if (path.orientation == kSteady || path.orientation == kSlerp || !path.pose.rpy_deg) return {};
            return "needs a path without rpy_deg, because the path determines the orientation";
          }),
      named_key(
          "singularity", &PathSpec::at_singularity,
          "What the controller does where the path passes a singularity and the joints cannot follow at its speed. "
          "`refuse`: it refuses the path. `slow`: it slows down there. `bend`: it lets the orientation leave the "
          "path (see below)."),
      key("orientation_tolerance_deg", &PathSpec::orientation_tolerance_deg, above(0, kMaxToleranceDeg, "deg"),
          "Largest angle by which the orientation may leave the path at a wrist singularity. The tool centre point "
          "stays on the path.")
          .only(when("singularity", {"bend"})),
  };
}

// All keys, those of its end included.
[[nodiscard]] inline Keys<PathSpec> path_keys() {
  Keys<PathSpec> keys{
      part(&PathSpec::pose,
           xyz_key("Position of the tool centre point at the end of a line, arc or spline. A circle passes "
                   "this point and ends where it began.")
               .required()),
      part(&PathSpec::pose, rpy_key()),
      part(&PathSpec::pose, pose_frame_key("xyz_mm", OnConveyor::kYes)),
  };
  keys.append(path_motion_keys());
  keys.append_parts(&PathSpec::pose, configuration_keys());
  return keys;
}

// The keys of the member `path` of `Kind`.
template <class Kind>
[[nodiscard]] Keys<Kind> keys_of_path() {
  Keys<Kind> keys;
  keys.append_parts(&Kind::path, path_keys());
  return keys;
}

// The same for a path through a second point.
template <class Kind>
[[nodiscard]] Keys<Kind> keys_of_path_via() {
  Keys<Kind> keys = keys_of_path<Kind>();
  keys.push_back(key("via_mm", &Kind::via_mm, target_place(),
                     "Point that the tool centre point passes between its start and `xyz_mm`.")
                     .required());
  return keys;
}

// The keys of the orientation at the end, and those of the motion, for a path whose end follows from a place that the
// key `place` gives.
template <class Kind>
[[nodiscard]] Keys<Kind> keys_of_path_from(std::string_view place) {
  Keys<Kind> keys{part(&Kind::path, part(&PathSpec::pose, rpy_key(place))),
                  part(&Kind::path, part(&PathSpec::pose, pose_frame_key(place, OnConveyor::kYes)))};
  keys.append_parts(&Kind::path, path_motion_keys());
  return keys;
}

[[nodiscard]] inline CartesianMove to_cartesian_move(SegmentRequest::Kind kind, const PathSpec& path,
                                                     const std::array<double, 3>& via_mm, Tag tag) {
  const double accel = path.accel_percent / 100.0;
  return {
      .kind = kind,
      .target = to_framed_pose(path.pose),
      .via_mm = to_vector(via_mm),
      .limits = {.speed_mm_s = path.speed_mm_s,
                 .accel_mm_s2 = accel * path.accel_mm_s2,
                 .jerk_mm_s3 = path.jerk_mm_s3,
                 .turn_speed_rad_s = path.turn_speed_deg_s * kRadPerDeg,
                 .turn_accel_rad_s2 = accel * path.turn_accel_deg_s2 * kRadPerDeg,
                 .turn_jerk_rad_s3 = path.turn_jerk_deg_s3 * kRadPerDeg,
                 .joint_accel = accel},
      .profile = path.profile,
      .blend_mm = path.blend_mm,
      .exact_stop = path.exact_stop,
      .orientation = path.orientation,
      .at_singularity = path.at_singularity,
      .orientation_tolerance_rad = path.orientation_tolerance_deg * kRadPerDeg,
      .tag = tag,
  };
}

}  // namespace armature::cosim
