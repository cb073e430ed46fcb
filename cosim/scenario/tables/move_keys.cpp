// [[move]]: commands for the controller.
#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/scenario/tables/tables.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/suggest.hpp"

namespace armature::cosim {
namespace {

constexpr double kMinSpeedPercent = 0.1;  // slower moves take longer than any run
constexpr double kMinOverridePercent = 1;
constexpr double kMaxSpeed = 1e6;  // mm/s, deg/s; as the others, far beyond any arm
constexpr double kMaxAccel = 1e9;
constexpr double kMaxJerk = 1e12;
constexpr double kMaxBlendMm = 10'000;
constexpr double kMaxTimeoutS = 86'400;

const Condition kJoint = when("type", {"joint"});
const Condition kPath = when("type", {"line", "arc", "circle"});
const Condition kMotion = when("type", {"joint", "line", "arc", "circle"});
const Condition kPin = when("type", {"dout", "wait_din"});
const Condition kScurve = when("profile", {"scurve"});

// Finds the frame that the move names.
std::string find_frame(MoveSpec& move, const KeyContext& context) {
  std::vector<std::string_view> known{kBaseFrameName, kToolFrameName};
  const std::vector<FrameSpec>& frames = context.scenario->frames;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    // A name that occurs twice is reported elsewhere. It is listed once here.
    if (std::ranges::find(known, frames[i].name) == known.end()) known.emplace_back(frames[i].name);
  }
  const auto named = std::ranges::find(frames, move.frame_name, &FrameSpec::name);
  if (move.frame_name == kToolFrameName) {
    move.frame = kToolFrameIndex;
  } else if (move.frame_name != kBaseFrameName) {
    if (named == frames.end()) {
      return "unknown frame \"" + printable(move.frame_name) + "\"" + suggestion(move.frame_name, known);
    }
    move.frame = static_cast<std::size_t>(named - frames.begin()) + 1;
  }
  return {};
}

// An S-curve of the joints needs jerk limits of the robot.
std::string check_joint_profile(const MoveSpec& move, const KeyContext& context) {
  const RobotSpec* robot = context.robot.spec;
  if (move.profile != "scurve" || robot == nullptr) return {};
  const std::span axes = std::span{robot->axes}.first(robot->axis_count);
  const auto lacking = std::ranges::find_if(axes, [](const AxisSpec& axis) { return !axis.max_jerk_deg_s3; });
  if (lacking == axes.end()) return {};
  return "an S-curve of the joints needs max_jerk_deg_s3 of every axis in " + context.robot.file + "; axis " +
         std::to_string(lacking - axes.begin() + 1) + " has none";
}

Rule place() {
  return between(-kMaxPlaceMm, kMaxPlaceMm, "mm");
}
Rule angle() {
  return between(-kMaxAngleDeg, kMaxAngleDeg, "deg");
}

// The keys of a pose, for moves with this condition.
Key<MoveSpec> xyz_key(const Condition& condition, std::string_view text) {
  return key("xyz_mm", &MoveSpec::xyz_mm, place(), text).needs(Needs::kKinematics).only(condition);
}
Key<MoveSpec> rpy_key(const Condition& condition, std::string_view text) {
  return key("rpy_deg", &MoveSpec::rpy_deg, angle(), text).without("keeps the orientation").only(condition);
}
Key<MoveSpec> frame_key(const Condition& condition, std::string_view text) {
  return key("frame", &MoveSpec::frame_name, anything(), text).only(condition).checked(find_frame);
}
Key<MoveSpec> profile_key(const Condition& condition, std::string_view text) {
  return key("profile", &MoveSpec::profile, one_of({"trapezoid", "scurve"}), text).only(condition);
}
Key<MoveSpec> jerk_key(std::string_view name, double MoveSpec::*member, std::string_view unit, std::string_view text) {
  return key(name, member, above(0, kMaxJerk, unit), text).required().only(kPath).only(kScurve);
}

}  // namespace

const KeyTable<MoveSpec>& move_keys() {
  constexpr std::string_view kFrameText =
      "Frame of the pose: `base`, the name of a `[[frame]]`, or `tool`, which is the frame of the tool at the begin of "
      "the move.";
  static const KeyTable<MoveSpec> kTable{
      .text = "Each table is one command for the controller.",
      .keys = {
          at_key<MoveSpec>("Time at which the controller gets the command."),
          named_key("type", &MoveSpec::type, kTypeNames,
                    "The command. `joint`: moves the joints. `line`, `arc`, `circle`: move the tool on a path. `hold`: "
                    "brakes on the path and waits there. `resume`: continues after a hold. `override`: sets the speed "
                    "of all moves from then on. `stop`: brakes on the path and drops all moves. `clear_fault`: leaves "
                    "the state Fault when the cause of the fault is gone. `dout`: switches an output of the tool. "
                    "`wait_din`: delays the commands after it until an input has the given level.")
              .required(),
          key("target_deg", &MoveSpec::target_deg, angle(), "Joint angles at the end of the move.")
              .required()
              .only(kJoint),
          xyz_key(kPath,
                  "Position of the tool centre point at the end of a line or arc. A circle passes this point and ends "
                  "where it began.")
              .required(),
          xyz_key(kJoint,
                  "Position of the tool centre point at the end of the move. The tool does not move on a straight line "
                  "to it.")
              .replaces("target_deg"),
          rpy_key(kMotion,
                  "Orientation of the tool at the end of the move: rotations about the fixed x, then y, then z axis. "
                  "See below for five-axis arms.")
              .only(beside("xyz_mm")),
          frame_key(kMotion, kFrameText).only(beside("xyz_mm")),
          key("via_mm", &MoveSpec::via_mm, place(),
              "Point that the tool centre point passes between its start and `xyz_mm`.")
              .required()
              .only(when("type", {"arc", "circle"})),
          key("speed_percent", &MoveSpec::speed_percent, between(kMinSpeedPercent, 100, "percent"),
              "Speed of the joints as a share of their speed limits.")
              .only(kJoint),
          key("speed_percent", &MoveSpec::speed_percent, between(kMinOverridePercent, 100, "percent"),
              "Speed of all moves from then on, as a share of their own speed.")
              .required()
              .only(when("type", {"override"})),
          profile_key(kJoint,
                      "Shape of the speed over time. `scurve` limits the jerk and needs `max_jerk_deg_s3` of every "
                      "axis of the robot.")
              .checked(check_joint_profile),
          profile_key(kPath, "Shape of the speed over time. `scurve` limits the jerk."),
          key("speed_mm_s", &MoveSpec::speed_mm_s, above(0, kMaxSpeed, "mm/s"),
              "Largest speed of the tool centre point.")
              .only(kPath),
          key("accel_mm_s2", &MoveSpec::accel_mm_s2, above(0, kMaxAccel, "mm/s^2"),
              "Largest acceleration of the tool centre point.")
              .only(kPath),
          jerk_key("jerk_mm_s3", &MoveSpec::jerk_mm_s3, "mm/s^3", "Largest jerk of the tool centre point."),
          key("turn_speed_deg_s", &MoveSpec::turn_speed_deg_s, above(0, kMaxSpeed, "deg/s"),
              "Largest angular speed of the tool.")
              .only(kPath),
          key("turn_accel_deg_s2", &MoveSpec::turn_accel_deg_s2, above(0, kMaxAccel, "deg/s^2"),
              "Largest angular acceleration of the tool.")
              .only(kPath),
          jerk_key("turn_jerk_deg_s3", &MoveSpec::turn_jerk_deg_s3, "deg/s^3", "Largest angular jerk of the tool."),
          key("blend_mm", &MoveSpec::blend_mm, between(0, kMaxBlendMm, "mm"),
              "Largest distance by which the rounded corner to the next path may leave the two paths. At 0 the tool "
              "stops exactly in the corner.")
              .only(kPath),
          pin_key<MoveSpec>("Number of the output or input.").only(kPin),
          level_key<MoveSpec>("Level of the output, or level that the wait ends at: 0 is low, 1 is high.").only(kPin),
          key("timeout_s", &MoveSpec::timeout_s, above(0, kMaxTimeoutS, "s"),
              "Longest time of the wait. When it has passed, the controller drops the wait and all moves after it.")
              .without("no limit")
              .only(when("type", {"wait_din"})),
      }};
  return kTable;
}

}  // namespace armature::cosim
