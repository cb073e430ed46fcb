// Keys that several kinds of [[move]] have: those of a pose, and those of a path of the tool.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cosim/scenario/keys/key.hpp"
#include "cosim/scenario/move_spec.hpp"

namespace armature::cosim {

// Far beyond any arm.
inline constexpr double kMaxSpeed = 1e6;  // mm/s, deg/s
inline constexpr double kMaxAccel = 1e9;  // mm/s^2, deg/s^2
inline constexpr double kMaxJerk = 1e12;  // mm/s^3, deg/s^3
inline constexpr double kMaxBlendMm = 10'000;
inline constexpr double kMinPercent = 0.1;  // of speeds and accelerations; slower moves take longer than any run

// Whether the frame of the conveyor is allowed.
enum class OnConveyor { kNo, kYes };

// Finds the frame of that name: 0 is the base. Returns an empty text, or the message.
[[nodiscard]] std::string find_frame(const std::string& name, std::size_t& frame, const KeyContext& context,
                                     OnConveyor on_conveyor = OnConveyor::kNo);

// Coordinates and angles of a target.
[[nodiscard]] Rule target_place();
[[nodiscard]] Rule target_angle();

// The keys of a pose. The last two exist only together with `xyz_mm`, which is optional, or with another key of a
// place.
[[nodiscard]] Key<PoseTarget> xyz_key(std::string_view text);
[[nodiscard]] Key<PoseTarget> rpy_key(std::string_view place = "xyz_mm");
[[nodiscard]] Key<PoseTarget> pose_frame_key(std::string_view place = "xyz_mm",
                                             OnConveyor on_conveyor = OnConveyor::kNo);

// The keys of the configuration of the arm at a pose.
[[nodiscard]] std::vector<Key<PoseTarget>> configuration_keys();
// Appends keys of the member `pose`.
template <class Kind>
void append_pose_keys(std::vector<Key<Kind>>& keys, PoseTarget Kind::*pose, std::vector<Key<PoseTarget>> added) {
  for (Key<PoseTarget>& key : added) keys.push_back(part(pose, std::move(key)));
}

[[nodiscard]] Rule profile_names();

// All keys of a path, those of its end included.
[[nodiscard]] std::vector<Key<PathSpec>> path_keys();
// Those of its motion: without its end.
[[nodiscard]] std::vector<Key<PathSpec>> path_motion_keys();

// The keys of a path through many points: those of its speed and its corners, and the frame of the points.
[[nodiscard]] std::vector<Key<PathSpec>> polyline_keys();

// The keys of the member `path` of `Kind`.
template <class Kind>
[[nodiscard]] std::vector<Key<Kind>> keys_of_path() {
  std::vector<Key<Kind>> keys;
  for (Key<PathSpec>& key : path_keys()) keys.push_back(part(&Kind::path, std::move(key)));
  return keys;
}

// The same for a path through a second point.
template <class Kind>
[[nodiscard]] std::vector<Key<Kind>> keys_of_path_via() {
  std::vector<Key<Kind>> keys = keys_of_path<Kind>();
  keys.push_back(key("via_mm", &Kind::via_mm, target_place(),
                     "Point that the tool centre point passes between its start and `xyz_mm`.")
                     .required());
  return keys;
}

// The keys of the orientation at the end, and those of the motion, for a path whose end follows from a place that the
// key `place` gives.
template <class Kind>
[[nodiscard]] std::vector<Key<Kind>> keys_of_path_from(std::string_view place) {
  std::vector<Key<Kind>> keys{part(&Kind::path, part(&PathSpec::pose, rpy_key(place))),
                              part(&Kind::path, part(&PathSpec::pose, pose_frame_key(place, OnConveyor::kYes)))};
  for (Key<PathSpec>& key : path_motion_keys()) keys.push_back(part(&Kind::path, std::move(key)));
  return keys;
}

}  // namespace armature::cosim
