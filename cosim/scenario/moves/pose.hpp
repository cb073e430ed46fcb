// A pose of the tool as the target of a command: its keys, and what the controller gets.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "controller/base/axes.hpp"
#include "controller/kinematics/configuration.hpp"
#include "controller/message/command.hpp"
#include "cosim/scenario/keys/key.hpp"

namespace armature::cosim {

inline constexpr std::string_view kBaseFrameName = "base";
inline constexpr std::string_view kToolFrameName = "tool";
inline constexpr std::size_t kToolFrameIndex = 255;

// A pose of the tool centre point.
struct PoseTarget {
  std::array<double, 3> xyz_mm{};
  std::optional<std::array<double, 3>> rpy_deg{};  // none: the orientation stays
  std::string frame_name{kBaseFrameName};          // as written
  std::size_t frame = 0;                           // of that name: 0 base, 1.. index + 1 in `frames`, kToolFrameIndex
  ShoulderSide shoulder = ShoulderSide::kNearest;
  ElbowSide elbow = ElbowSide::kNearest;
  WristSide wrist = WristSide::kNearest;
  std::optional<PerAxis<std::int64_t>> turns{};
};

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
[[nodiscard]] Keys<PoseTarget> configuration_keys();

[[nodiscard]] FramedPose to_framed_pose(const PoseTarget& target);

}  // namespace armature::cosim
