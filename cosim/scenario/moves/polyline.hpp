// The type `polyline` of [[move]].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "controller/message/command.hpp"
#include "cosim/scenario/moves/entry.hpp"
#include "cosim/scenario/moves/path.hpp"

namespace armature::cosim {

// Lines through many points. The tool keeps its orientation.
struct PolylineSpec {
  PathSpec path{};  // its pose has only a frame: that of the points
  std::string points_file{};
  std::vector<std::array<double, 3>> points_mm{};  // from that file, at least one; none is equal to the one before
};

// The keys of its speed and its corners, and the frame of the points.
[[nodiscard]] inline Keys<PathSpec> polyline_keys() {
  constexpr std::array<std::string_view, 3> kShared{"speed_mm_s", "accel_mm_s2", "blend_mm"};
  Keys<PathSpec> keys;
  const Keys<PathSpec> all = path_keys();
  for (const PlainKey& key : all.plain()) {
    if (std::ranges::find(kShared, key.info.name) != kShared.end()) keys.push_back(Key<PathSpec>{key});
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

// The line to a point. The last one ends in a stop.
[[nodiscard]] inline Command to_command(const PolylineSpec& polyline, std::size_t point, Tag tag) {
  CartesianMove line = to_cartesian_move(SegmentRequest::Kind::kLine, polyline.path, {}, tag);
  line.target.position_mm = to_vector(polyline.points_mm.at(point));
  if (point + 1 == polyline.points_mm.size()) line.blend_mm = 0.0;
  return line;
}

template <>
[[nodiscard]] inline const MoveEntry<PolylineSpec>& move_entry<PolylineSpec>() {
  static const MoveEntry<PolylineSpec> kEntry = [] {
    MoveEntry<PolylineSpec> entry{
        .name = "polyline",
        .command = [](const PolylineSpec& polyline, Tag tag) -> Command {
          return to_command(polyline, polyline.points_mm.size() - 1, tag);
        },
        .text = "moves the tool on straight lines through the points of a file, and keeps its orientation",
        .queued = true,
        .keys = {key("points_file", &PolylineSpec::points_file, anything(),
                     "CSV file with the points, in the folder of the scenario: a line `x_mm,y_mm,z_mm`, then a line "
                     "for each point, at most 100000.")
                     .required()
                     .needs(Needs::kKinematics)}};
    entry.keys.append_parts(&PolylineSpec::path, polyline_keys());
    return entry;
  }();
  return kEntry;
}

}  // namespace armature::cosim
