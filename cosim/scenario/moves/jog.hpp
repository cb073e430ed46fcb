// The type `jog` of [[move]].
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "controller/base/angle_units.hpp"
#include "controller/base/axes.hpp"
#include "controller/message/command.hpp"
#include "cosim/scenario/moves/entry.hpp"
#include "cosim/scenario/moves/pose.hpp"
#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {

struct JogSpec {
  std::optional<PerAxis<double>> joint_deg_s{};  // none: a velocity of the tool
  std::array<double, 3> tool_mm_s{};
  std::array<double, 3> tool_deg_s{};
  std::string frame_name{kBaseFrameName};  // as written
  std::size_t frame = 0;                   // as in PoseTarget
  double duration_s = 0;                   // above 0
  ProfileKind profile = ProfileKind::kTrapezoid;
  double accel_percent = 100;  // of the joints
  double accel_mm_s2 = 1000, jerk_mm_s3 = 0;
  double turn_accel_deg_s2 = 900, turn_jerk_deg_s3 = 0;
};

[[nodiscard]] inline Command to_jog(const JogSpec& spec, Tag tag) {
  Jog jog{.duration = at_least_ticks(spec.duration_s),
          .profile = spec.profile,
          .accel_share = spec.accel_percent / 100.0,
          .tool = {.accel_mm_s2 = spec.accel_mm_s2,
                   .turn_accel_rad_s2 = spec.turn_accel_deg_s2 * kRadPerDeg,
                   .jerk_mm_s3 = spec.jerk_mm_s3,
                   .turn_jerk_rad_s3 = spec.turn_jerk_deg_s3 * kRadPerDeg},
          .tag = tag};
  if (spec.joint_deg_s) {
    jog.joint_rad_s = make_per_axis([&](std::size_t i) { return (*spec.joint_deg_s)[i] * kRadPerDeg; });
    return jog;
  }
  jog.kind = Jog::Kind::kTool;
  jog.frame = FrameId{static_cast<std::uint8_t>(spec.frame)};
  jog.move_mm_s = to_vector(spec.tool_mm_s);
  jog.turn_rad_s = kRadPerDeg * to_vector(spec.tool_deg_s);
  return jog;
}

inline constexpr double kMinJogAccelPercent = 1;

template <>
[[nodiscard]] inline const MoveEntry<JogSpec>& move_entry<JogSpec>() {
  constexpr auto kJerkKey = [](std::string_view name, double JogSpec::*member, std::string_view unit,
                               std::string_view text) {
    return key(name, member, above(0, kMaxJerk, unit), text)
        .required()
        .only(beside("tool_mm_s"))
        .only(when("profile", {"scurve"}));
  };
  // The velocity of the tool has six components.
  constexpr auto kCheckAxes = [](JogSpec&, const KeyContext& context) -> std::string {
    const RobotSpec* robot = context.robot.spec;
    if (robot == nullptr || robot->axis_count == kAxes) return {};
    return fmt::format("a velocity of the tool needs six axes, the robot has {}", robot->axis_count);
  };
  static const MoveEntry<JogSpec> kEntry{
      .name = "jog",
      .command = to_jog,
      .text = "moves the joints or the tool with a velocity, when no other move runs or waits",
      .keys =
          {key("joint_deg_s", &JogSpec::joint_deg_s, between(-kMaxSpeed, kMaxSpeed, "deg/s"),
               "Speed of each joint, up to its speed limit. A joint stops at its soft limit.")
               .required(),
           key("tool_mm_s", &JogSpec::tool_mm_s, between(-kMaxSpeed, kMaxSpeed, "mm/s"),
               "Velocity of the tool centre point. The arm stops where a joint cannot follow.")
               .without({})
               .needs(Needs::kKinematics)
               .replaces("joint_deg_s")
               .checked(kCheckAxes),
           key("tool_deg_s", &JogSpec::tool_deg_s, between(-kMaxSpeed, kMaxSpeed, "deg/s"),
               "Angular velocity of the tool about the axes of the frame.")
               .only(beside("tool_mm_s")),
           key("frame", &JogSpec::frame_name, anything(),
               "Frame of the velocity: `base`, the name of a `[[frame]]`, or `tool`, whose axes turn with the "
               "tool.")
               .only(beside("tool_mm_s"))
               .checked([](JogSpec& jog, const KeyContext& context) {
                 return find_frame(jog.frame_name, jog.frame, context);
               }),
           key("duration_s", &JogSpec::duration_s, above(0, kMaxDurationS, "s"),
               "Time after which the arm comes to rest. Another `jog` before that replaces the velocity and begins "
               "its own time.")
               .required(),
           profile_key(
               &JogSpec::profile,
               "Shape of the speed over time. `scurve` limits the jerk: of the joints to their `max_jerk_deg_s3`, of "
               "the tool when its commanded velocity changes.")
               .checked([](JogSpec& jog, const KeyContext& context) {
                 return jog.joint_deg_s ? lacking_jerk(jog.profile, context) : std::string{};
               }),
           key("accel_percent", &JogSpec::accel_percent, between(kMinJogAccelPercent, 100, "percent"),
               "Acceleration of the joints as a share of their limits.")
               .only(beside("joint_deg_s")),
           key("accel_mm_s2", &JogSpec::accel_mm_s2, above(0, kMaxAccel, "mm/s^2"),
               "Largest acceleration of the tool centre point.")
               .only(beside("tool_mm_s")),
           key("turn_accel_deg_s2", &JogSpec::turn_accel_deg_s2, above(0, kMaxAccel, "deg/s^2"),
               "Largest angular acceleration of the tool.")
               .only(beside("tool_mm_s")),
           kJerkKey("jerk_mm_s3", &JogSpec::jerk_mm_s3, "mm/s^3", "Largest jerk of the tool centre point."),
           kJerkKey("turn_jerk_deg_s3", &JogSpec::turn_jerk_deg_s3, "deg/s^3", "Largest angular jerk of the tool.")},
      .details = [](const JogSpec& jog) { return fmt::format(" for {} s", number_text(jog.duration_s)); },
  };
  return kEntry;
}

}  // namespace armature::cosim
