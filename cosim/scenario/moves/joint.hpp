// The type `joint` of [[move]].
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "controller/base/angle_units.hpp"
#include "controller/base/axes.hpp"
#include "controller/message/command.hpp"
#include "cosim/scenario/moves/entry.hpp"
#include "cosim/scenario/moves/pose.hpp"
#include "cosim/scenario/tables/shared_keys.hpp"

namespace armature::cosim {

struct JointSpec {
  std::optional<PerAxis<double>> target_deg{};  // none: `pose` is the target
  PoseTarget pose{};
  double speed_percent = 100.0;
  double accel_percent = 100.0;
  ProfileKind profile = ProfileKind::kTrapezoid;
  enum class When : std::uint8_t { kInOrder, kNow };
  When when = When::kInOrder;
  double blend_deg = 0, blend_percent = 0;  // at most one of both is written

  [[nodiscard]] constexpr bool blends() const { return blend_deg > 0 || blend_percent > 0; }
};

[[nodiscard]] inline Command to_joint_command(const JointSpec& move, Tag tag) {
  const double speed = move.speed_percent / 100.0, accel = move.accel_percent / 100.0;
  const JointBlend blend{.rad = move.blend_deg * kRadPerDeg, .share = move.blend_percent / 100.0};
  if (!move.target_deg) {
    return PoseMove{.target = to_framed_pose(move.pose),
                    .speed = speed,
                    .accel = accel,
                    .profile = move.profile,
                    .blend = blend,
                    .tag = tag};
  }
  JointMove joint{.target = {},
                  .speed = speed,
                  .accel = accel,
                  .profile = move.profile,
                  .now = move.when == JointSpec::When::kNow,
                  .blend = blend,
                  .tag = tag};
  for (std::size_t i = 0; i < kAxes; ++i) joint.target[i] = Radians{(*move.target_deg)[i] * kRadPerDeg};
  return joint;
}

template <>
[[nodiscard]] inline const MoveEntry<JointSpec>& move_entry<JointSpec>() {
  static const MoveEntry<JointSpec> kEntry = [&] {
    MoveEntry<JointSpec> entry{
        .name = "joint",
        .command = to_joint_command,
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
             profile_key(
                 &JointSpec::profile,
                 "Shape of the speed over time. `scurve` limits the jerk and needs `max_jerk_deg_s3` of every axis "
                 "of the robot.")
                 .checked(
                     [](JointSpec& move, const KeyContext& context) { return lacking_jerk(move.profile, context); }),
             named_key(
                 "when", &JointSpec::when,
                 "`in_order`: the move begins after the moves before it. `now`: it begins at once, also in motion, and "
                 "replaces all moves before it.")
                 .only(beside("target_deg")),
             key("blend_deg", &JointSpec::blend_deg, between(0, kMaxAngleDeg, "deg"),
                 "When another `joint` move or a path follows, the joints pass the target without a stop. This is the "
                 "largest deviation of any joint from the target there. At 0 they stop exactly at the target. In a "
                 "corner "
                 "with a path only the limits of the joints apply, not those of the tool."),
             key("blend_percent", &JointSpec::blend_percent, between(0, 100, "percent"),
                 "The same deviation as a share. 100 % is half of a joint's way in this move or in the next one, "
                 "whichever is shorter. The joint is the one that moves farthest.")
                 .replaces("blend_deg")},
    };
    entry.keys.append_parts(&JointSpec::pose, configuration_keys());
    return entry;
  }();
  return kEntry;
}

}  // namespace armature::cosim
