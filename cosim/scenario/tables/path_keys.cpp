#include "cosim/scenario/tables/path_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "controller/command/command.hpp"
#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/text/names.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/suggest.hpp"

namespace armature::cosim {
namespace {

constexpr double kMaxToleranceDeg = 30;  // less than CartesianMove::kMostTolerance_rad

}  // namespace

std::string find_frame(const std::string& name, std::size_t& frame, const KeyContext& context, OnConveyor on_conveyor) {
  std::vector<std::string_view> known{kBaseFrameName, kToolFrameName};
  if (name == kConveyorFrameName && context.scenario->conveyor) {
    if (on_conveyor == OnConveyor::kNo) return "only a path of the tool can move with the conveyor";
    frame = kConveyorFrame.index;
    return {};
  }
  const std::vector<FrameSpec>& frames = context.scenario->frames;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    // A name that occurs twice is reported elsewhere. It is listed once here.
    if (std::ranges::find(known, frames[i].name) == known.end()) known.emplace_back(frames[i].name);
  }
  const auto named = std::ranges::find(frames, name, &FrameSpec::name);
  if (name == kToolFrameName) {
    frame = kToolFrameIndex;
  } else if (name != kBaseFrameName) {
    if (named == frames.end()) {
      return "unknown frame \"" + printable(name) + "\"" + suggestion(name, known);
    }
    frame = static_cast<std::size_t>(named - frames.begin()) + 1;
  }
  return {};
}

namespace {

Key<PathSpec> jerk_key(std::string_view name, double PathSpec::*member, std::string_view unit, std::string_view text) {
  return key(name, member, above(0, kMaxJerk, unit), text).required().only(when("profile", {"scurve"}));
}

}  // namespace

Rule target_place() {
  return between(-kMaxPlaceMm, kMaxPlaceMm, "mm");
}
Rule target_angle() {
  return between(-kMaxAngleDeg, kMaxAngleDeg, "deg");
}

Key<PoseTarget> xyz_key(std::string_view text) {
  return key("xyz_mm", &PoseTarget::xyz_mm, target_place(), text).without({}).needs(Needs::kKinematics);
}

Key<PoseTarget> rpy_key(std::string_view place) {
  return key("rpy_deg", &PoseTarget::rpy_deg, target_angle(),
             "Orientation of the tool at the end of the move. The angles are rotations about the x, y and z axes of "
             "the "
             "frame, in this order. The axes do not turn with the tool. See below for five-axis arms.")
      .without("keeps the orientation")
      .only(beside(place));
}

Key<PoseTarget> pose_frame_key(std::string_view place, OnConveyor on_conveyor) {
  return key("frame", &PoseTarget::frame_name, anything(),
             "Frame of the pose: `base`, the name of a `[[frame]]`, `tool` or, for a path, `conveyor`. `tool` is the "
             "frame of the tool where the move starts. `conveyor` is that of a part on the belt of `[conveyor]`.")
      .only(beside(place))
      .checked([on_conveyor](PoseTarget& pose, const KeyContext& context) {
        return find_frame(pose.frame_name, pose.frame, context, on_conveyor);
      });
}

std::vector<Key<PoseTarget>> configuration_keys() {
  constexpr auto kCheckWrist = [](PoseTarget& pose, const KeyContext& context) -> std::string {
    const RobotSpec* robot = context.robot.spec;
    if (robot == nullptr || robot->axis_count == kAxes || pose.wrist == WristSide::kNearest) return {};
    return fmt::format("only the wrist of a six-axis arm has two sides, the robot has {} axes", robot->axis_count);
  };
  return {
      named_key("shoulder", &PoseTarget::shoulder,
                "Side of axis 1 at the end of the move: `front` faces the pose, `back` faces away from it. `nearest` "
                "is the side that the shortest move leads to. See below for configurations.")
          .only(beside("xyz_mm")),
      named_key("elbow", &PoseTarget::elbow, "Side of the elbow: above or below the line to the wrist.")
          .only(beside("xyz_mm")),
      named_key("wrist", &PoseTarget::wrist,
                "Side of the wrist: with joint 4 in its zero position, `noflip` bends the hand down, `flip` up.")
          .only(beside("xyz_mm"))
          .checked(kCheckWrist),
      key("turns", &PoseTarget::turns, between(-kMostTurns, kMostTurns),
          "Number of turns of each joint: n for an angle between 360 n - 180 and 360 n + 180 degrees.")
          .without("nearest")
          .only(beside("xyz_mm")),
  };
}

Rule profile_names() {
  return one_of({"trapezoid", "scurve"});
}

std::vector<Key<PathSpec>> path_keys() {
  std::vector<Key<PathSpec>> keys{
      part(&PathSpec::pose,
           xyz_key("Position of the tool centre point at the end of a line, arc or spline. A circle passes "
                   "this point and ends where it began.")
               .required()),
      part(&PathSpec::pose, rpy_key()),
      part(&PathSpec::pose, pose_frame_key("xyz_mm", OnConveyor::kYes)),
  };
  for (Key<PathSpec>& key : path_motion_keys()) keys.push_back(std::move(key));
  append_pose_keys(keys, &PathSpec::pose, configuration_keys());
  return keys;
}

std::vector<Key<PathSpec>> path_motion_keys() {
  return {
      key("profile", &PathSpec::profile, profile_names(), "Shape of the speed over time. `scurve` limits the jerk."),
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
          "tool stops exactly in the corner."),
      key("exact_stop", &PathSpec::exact_stop, anything(),
          "`true`: the tool stops at the end of the path, even if the next path goes on in the same direction.")
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

std::vector<Key<PathSpec>> polyline_keys() {
  constexpr std::array<std::string_view, 3> kShared{"speed_mm_s", "accel_mm_s2", "blend_mm"};
  std::vector<Key<PathSpec>> keys;
  for (Key<PathSpec>& key : path_keys()) {
    if (std::ranges::find(kShared, key.info.name) != kShared.end()) keys.push_back(std::move(key));
  }
  keys.push_back(part(&PathSpec::pose, key("frame", &PoseTarget::frame_name, anything(),
                                           "Frame of the points: `base` or the name of a `[[frame]]`.")
                                           .checked([](PoseTarget& pose, const KeyContext& context) -> std::string {
                                             if (pose.frame_name == kToolFrameName)
                                               return "the points of a polyline need `base` or a `[[frame]]`";
                                             return find_frame(pose.frame_name, pose.frame, context);
                                           })));
  return keys;
}

}  // namespace armature::cosim
