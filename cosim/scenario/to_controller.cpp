#include "cosim/scenario/to_controller.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <variant>

#include "controller/core/angle_units.hpp"
#include "controller/core/overloaded.hpp"
#include "controller/core/timebase.hpp"

namespace armature::cosim {
namespace {

// Whole ticks that last at least this long. A time that is a whole number of ticks except for rounding gives that
// number.
Ticks at_least_ticks(double s) {
  return Ticks{static_cast<std::int64_t>(std::ceil(s / kTickSeconds - 1e-6))};
}

ProfileKind to_profile_kind(const std::string& profile) {
  return profile == "scurve" ? ProfileKind::kSCurve : ProfileKind::kTrapezoid;
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

Command to_joint_command(const JointSpec& move, std::uint32_t tag) {
  const double speed = move.speed_percent / 100.0, accel = move.accel_percent / 100.0;
  const ProfileKind profile = to_profile_kind(move.profile);
  const JointBlend blend{.rad = move.blend_deg * kRadPerDeg, .share = move.blend_percent / 100.0};
  if (!move.target_deg) {
    return PoseMove{.target = to_framed_pose(move.pose),
                    .speed = speed,
                    .accel = accel,
                    .profile = profile,
                    .blend = blend,
                    .tag = tag};
  }
  JointMove joint{.target = {},
                  .speed = speed,
                  .accel = accel,
                  .profile = profile,
                  .now = move.when == "now",
                  .blend = blend,
                  .tag = tag};
  for (std::size_t i = 0; i < kAxes; ++i) joint.target[i] = Radians{(*move.target_deg)[i] * kRadPerDeg};
  return joint;
}

CartesianMove to_cartesian_move(SegmentRequest::Kind kind, const PathSpec& path, const std::array<double, 3>& via_mm,
                                std::uint32_t tag) {
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
      .profile = to_profile_kind(path.profile),
      .blend_mm = path.blend_mm,
      .exact_stop = path.exact_stop,
      .orientation = path.orientation,
      .at_singularity = path.at_singularity,
      .orientation_tolerance_rad = path.orientation_tolerance_deg * kRadPerDeg,
      .tag = tag,
  };
}

Jog to_jog(const JogSpec& spec, std::uint32_t tag) {
  Jog jog{.duration = at_least_ticks(spec.duration_s),
          .profile = to_profile_kind(spec.profile),
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

PathOutputs to_path_outputs(const std::vector<PathOutputSpec>& specs, bool on_path) {
  PathOutputs outputs;
  for (const PathOutputSpec& spec : specs) {
    const bool in_time = spec.before_s || spec.after_s;
    outputs.list[outputs.count++] = {.pin = static_cast<std::uint8_t>(spec.pin),
                                     .level = spec.level,
                                     .from = spec.from == "start" ? PathOutput::From::kStart : PathOutput::From::kEnd,
                                     .unit = in_time || !on_path ? PathOutput::Unit::kSeconds : PathOutput::Unit::kMm,
                                     .offset = in_time ? spec.after_s.value_or(0) - spec.before_s.value_or(0)
                                                       : spec.after_mm.value_or(0) - spec.before_mm.value_or(0)};
  }
  return outputs;
}

Command command_of(const MoveSpec& move) {
  using Segment = SegmentRequest::Kind;
  const std::uint32_t tag = move.index;
  return std::visit(
      Overloaded{
          [tag](const JointSpec& joint) { return to_joint_command(joint, tag); },
          [tag](const LineSpec& line) -> Command { return to_cartesian_move(Segment::kLine, line.path, {}, tag); },
          [tag](const ArcSpec& arc) -> Command { return to_cartesian_move(Segment::kArc, arc.path, arc.via_mm, tag); },
          [tag](const CircleSpec& circle) -> Command {
            return to_cartesian_move(Segment::kCircle, circle.path, circle.via_mm, tag);
          },
          [tag](const ArcAboutSpec& arc) -> Command {
            CartesianMove about = to_cartesian_move(Segment::kArcAbout, arc.path, arc.center_mm, tag);
            about.about = {
                .axis = to_vector(arc.axis), .angle_rad = arc.angle_deg * kRadPerDeg, .advance_mm = arc.advance_mm};
            return about;
          },
          [tag](const PolylineSpec& polyline) { return to_command(polyline, polyline.points_mm.size() - 1, tag); },
          [tag](const SplineSpec& spline) -> Command {
            CartesianMove curve = to_cartesian_move(Segment::kSpline, spline.path, {}, tag);
            curve.through.count = static_cast<std::uint8_t>(spline.through_mm.size());
            std::ranges::transform(spline.through_mm, curve.through.mm.begin(), to_vector);
            return curve;
          },
          [tag](const DwellSpec& dwell) -> Command {
            return Dwell{.duration = at_least_ticks(dwell.duration_s), .tag = tag};
          },
          [](const HoldSpec&) -> Command { return Hold{}; },
          [](const ResumeSpec&) -> Command { return Resume{}; },
          [tag](const OverrideSpec& wanted) -> Command {
            return SetOverride{.share = wanted.speed_percent / 100.0, .tag = tag};
          },
          [](const StopSpec& stop) -> Command {
            return Stop{.kind = stop.mode == "soft" ? Stop::Kind::kSoft : Stop::Kind::kQuick};
          },
          [tag](const HomeSpec& home) -> Command {
            std::uint8_t axes = 0;
            for (const std::int64_t axis : home.axes) axes = static_cast<std::uint8_t>(axes | 1u << (axis - 1));
            return Home{.axes = axes, .tag = tag};
          },
          [tag](const ClearFaultSpec&) -> Command { return ClearFault{.tag = tag}; },
          [tag](const DoutSpec& output) -> Command {
            return SetOutput{.pin = static_cast<std::uint8_t>(output.pin), .level = output.level, .tag = tag};
          },
          [tag](const WaitDinSpec& wait) -> Command {
            return WaitInput{.pin = static_cast<std::uint8_t>(wait.pin),
                             .level = wait.level,
                             .timeout = at_least_ticks(wait.timeout_s),
                             .tag = tag};
          },
          [tag](const JogSpec& jog) -> Command { return to_jog(jog, tag); },
      },
      move.kind);
}

}  // namespace

Eigen::Vector3d to_vector(const std::array<double, 3>& xyz) {
  return {xyz[0], xyz[1], xyz[2]};
}

Transform to_transform(const PoseSpec& pose) {
  const auto& [roll, pitch, yaw] = pose.rpy_deg;
  return {rotation_from_rpy(roll * kRadPerDeg, pitch * kRadPerDeg, yaw * kRadPerDeg), to_vector(pose.xyz_mm)};
}

Command to_command(const PolylineSpec& polyline, std::size_t point, std::uint32_t tag) {
  CartesianMove line = to_cartesian_move(SegmentRequest::Kind::kLine, polyline.path, {}, tag);
  line.target.position_mm = to_vector(polyline.points_mm.at(point));
  if (point + 1 == polyline.points_mm.size()) line.blend_mm = 0.0;
  return line;
}

Command to_command(const MoveSpec& move) {
  Command command = command_of(move);
  std::visit(
      [&](auto& any) {
        if constexpr (requires { any.outputs; })
          any.outputs = to_path_outputs(move.outputs, path_of(move.kind) != nullptr);
      },
      command);
  return command;
}

Command to_command(const StreamSpec& stream, std::size_t point) {
  const StreamSpec::Point& from = stream.points.at(point);
  StreamPoint to{.kind = StreamPoint::Kind::kJoints,
                 .first = point == 0,
                 .last = point + 1 == stream.points.size(),
                 .time = Ticks{from.ticks},
                 .delay = Ticks{std::max<std::int64_t>(1, std::llround(stream.delay_s() / kTickSeconds))},
                 .profile = to_profile_kind(stream.profile),
                 .tag = kFirstStreamTag + static_cast<std::uint32_t>(stream.index)};
  const PerAxis<double>& v = from.values;
  if (stream.kind == StreamSpec::Kind::kJoints) {
    to.joints = make_per_axis([&](std::size_t i) { return Radians{v[i] * kRadPerDeg}; });
  } else {
    const Transform pose = to_transform({.xyz_mm = {v[0], v[1], v[2]}, .rpy_deg = {v[3], v[4], v[5]}});
    to.kind = StreamPoint::Kind::kTool;
    to.position_mm = pose.position_mm;
    to.rotation = pose.rotation;
  }
  return to;
}

}  // namespace armature::cosim
