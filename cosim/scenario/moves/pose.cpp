#include "cosim/scenario/moves/pose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "cosim/scenario/moves/entry.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/scenario/to_controller.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/suggest.hpp"

namespace armature::cosim {

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

Keys<PoseTarget> configuration_keys() {
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
      key("turns", &PoseTarget::turns, between(-kMaxTurns, kMaxTurns),
          "Number of turns of each joint: n for an angle between 360 n - 180 and 360 n + 180 degrees.")
          .without("nearest")
          .only(beside("xyz_mm")),
  };
}

FramedPose to_framed_pose(const PoseTarget& target) {
  FramedPose pose;
  pose.frame = FrameId{static_cast<std::uint8_t>(target.frame)};
  pose.position_mm = to_vector(target.xyz_mm);
  if (target.rpy_deg) pose.rotation = to_transform({.xyz_mm = {}, .rpy_deg = *target.rpy_deg}).rotation;
  pose.configuration = {.shoulder = target.shoulder, .elbow = target.elbow, .wrist = target.wrist};
  if (target.turns) {
    pose.configuration.turns =
        make_per_axis([&](std::size_t i) { return static_cast<std::int8_t>((*target.turns)[i]); });
  }
  return pose;
}

}  // namespace armature::cosim
