// [[move]]: the commands for the controller. Each kind has a struct with its keys in the user's units.
//
// CommandKind is the list of all kinds. tables/move_kinds.hpp has an entry for each; to_controller makes the commands.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "controller/command/command.hpp"
#include "controller/core/axes.hpp"
#include "controller/kinematics/configuration.hpp"
#include "controller/trajectory/path/segment_request.hpp"
#include "cosim/scenario/pin_spec.hpp"

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

// What all paths of the tool have.
struct PathSpec {
  PoseTarget pose{};                  // at the end; of a circle the third point
  std::string profile = "trapezoid";  // "trapezoid" | "scurve"
  double speed_mm_s = 100, accel_mm_s2 = 1000, jerk_mm_s3 = 0;
  double turn_speed_deg_s = 90, turn_accel_deg_s2 = 900, turn_jerk_deg_s3 = 0;
  double accel_percent = 100;  // of all accelerations
  double blend_mm = 0;
  bool exact_stop = false;
  CartesianMove::Orientation orientation = CartesianMove::Orientation::kSteady;
  AtSingularity at_singularity = AtSingularity::kSlow;
  double orientation_tolerance_deg = 5;
};

struct JointSpec {
  std::optional<PerAxis<double>> target_deg{};  // none: `pose` is the target
  PoseTarget pose{};
  double speed_percent = 100.0;
  double accel_percent = 100.0;
  std::string profile = "trapezoid";        // "trapezoid" | "scurve"
  std::string when = "in_order";            // "in_order" | "now"
  double blend_deg = 0, blend_percent = 0;  // at most one of both is written

  [[nodiscard]] constexpr bool blends() const { return blend_deg > 0 || blend_percent > 0; }
};

struct LineSpec {
  PathSpec path{};
};

struct ArcSpec {
  PathSpec path{};
  std::array<double, 3> via_mm{};  // second point
};

struct CircleSpec {
  PathSpec path{};
  std::array<double, 3> via_mm{};  // second point
};

struct ArcAboutSpec {
  PathSpec path{};  // its pose has only an orientation and a frame
  std::array<double, 3> center_mm{};
  std::array<double, 3> axis{0, 0, 1};
  double angle_deg = 360;
  double advance_mm = 0;
};

struct SplineSpec {
  PathSpec path{};
  std::vector<std::array<double, 3>> through_mm{};  // points between its start and its end
};

struct DwellSpec {
  double duration_s = 0;  // above 0
};

// Lines through many points. The tool keeps its orientation.
struct PolylineSpec {
  PathSpec path{};  // its pose has only a frame: that of the points
  std::string points_file{};
  std::vector<std::array<double, 3>> points_mm{};  // from that file, at least one; none is equal to the one before
};

struct HoldSpec {};

struct ResumeSpec {};

struct OverrideSpec {
  double speed_percent = 100.0;
};

struct StopSpec {
  std::string mode = "quick";  // "quick" | "soft"
};

struct ClearFaultSpec {};

struct HomeSpec {
  std::vector<std::int64_t> axes{};  // 1..6; empty: all
};

struct DoutSpec {
  std::int64_t pin = 1;
  bool level = false;
};

struct WaitDinSpec {
  std::int64_t pin = 1;
  bool level = false;
  double timeout_s = 0;  // 0: no limit
};

struct JogSpec {
  std::optional<PerAxis<double>> joint_deg_s{};  // none: a velocity of the tool
  std::array<double, 3> tool_mm_s{};
  std::array<double, 3> tool_deg_s{};
  std::string frame_name{kBaseFrameName};  // as written
  std::size_t frame = 0;                   // as in PoseTarget
  double duration_s = 0;                   // above 0
  std::string profile = "trapezoid";       // "trapezoid" | "scurve"
  double accel_percent = 100;              // of the joints
  double accel_mm_s2 = 1000, jerk_mm_s3 = 0;
  double turn_accel_deg_s2 = 900, turn_jerk_deg_s3 = 0;
};

// The members of a struct are the keys of its kind.
using CommandKind =
    std::variant<JointSpec, LineSpec, ArcSpec, CircleSpec, ArcAboutSpec, SplineSpec, PolylineSpec, DwellSpec, HoldSpec,
                 ResumeSpec, OverrideSpec, StopSpec, ClearFaultSpec, DoutSpec, WaitDinSpec, JogSpec, HomeSpec>;

struct MoveSpec {
  double at_s = 0;
  CommandKind kind{};
  std::vector<PathOutputSpec> outputs{};  // of a path or a joint move
  int line = 0;                           // in the scenario file, for messages
  std::uint32_t index = 0;                // in the scenario file, as in `move[3]`; the tag of the command
};

// The path of the tool; null: the command has none.
[[nodiscard]] constexpr const PathSpec* path_of(const CommandKind& kind) {
  return std::visit(
      [](const auto& move) -> const PathSpec* {
        if constexpr (requires { move.path; }) {
          return &move.path;
        } else {
          return nullptr;
        }
      },
      kind);
}

// The pose that the command moves the tool to; null: none, or joint angles.
[[nodiscard]] constexpr const PoseTarget* pose_of(const CommandKind& kind) {
  if (const PathSpec* path = path_of(kind)) return &path->pose;
  const auto* joint = std::get_if<JointSpec>(&kind);
  return joint != nullptr && !joint->target_deg ? &joint->pose : nullptr;
}

}  // namespace armature::cosim
