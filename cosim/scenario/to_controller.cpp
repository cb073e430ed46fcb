#include "cosim/scenario/to_controller.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <variant>

#include "controller/base/angle_units.hpp"
#include "controller/base/overloaded.hpp"
#include "controller/base/timebase.hpp"

namespace armature::cosim {
namespace {

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

}  // namespace

Transform to_transform(const PoseSpec& pose) {
  const auto& [roll, pitch, yaw] = pose.rpy_deg;
  return {rotation_from_rpy(roll * kRadPerDeg, pitch * kRadPerDeg, yaw * kRadPerDeg), to_vector(pose.xyz_mm)};
}

Command to_command(const CommandSpec& move) {
  Command command =
      std::visit([&]<class Kind>(const Kind& kind) { return move_entry<Kind>().command(kind, move.index); }, move.kind);
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
                 .profile = stream.profile,
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
