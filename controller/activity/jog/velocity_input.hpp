// The commands of a velocity source.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/activity/jog/tool_velocity.hpp"
#include "controller/base/axes.hpp"
#include "controller/base/tag.hpp"
#include "controller/base/units.hpp"
#include "controller/trajectory/profile/time_law.hpp"

namespace armature {

// How velocities change.
struct VelocityManner {
  ProfileKind profile = ProfileKind::kTrapezoid;  // kSCurve: needs max_jerk_rad_s3 > 0 for every axis; joints only
  double accel_share = 1.0;   // of the axes' acceleration limits, (0, 1]; for velocities of the joints, not for a stop
  ToolVelocityLimits tool{};  // for velocities of the tool
};

struct VelocityCommand {
  enum class Kind : std::uint8_t {
    kJoints,    // joint_rad_s, until the next command or the time-out
    kTool,      // tool, likewise; begins when the joints are at rest
    kHalt,      // come to rest within the limits of the motion
    kSoftStop,  // the same for a stop
    kStop,      // come to rest with the full acceleration; jerk is not limited
  };
  Kind kind = Kind::kJoints;
  PerAxis<double> joint_rad_s{};           // limited to the speeds of the axes; 0 for axes that the robot does not have
  ToolTwist tool{};                        // finite
  Ticks time_out{};                        // the command has no effect after this time; 0: that of VelocitySettings
  std::optional<VelocityManner> manner{};  // from this command on; none: as before
  Tag tag{};                               // of the command of core 1
};

class VelocityInput {
 public:
  // The latest command since the last call, none without one. Called once per tick. A kStop is never replaced by a
  // later command, a kSoftStop only by a kStop, and a kHalt only by these two.
  [[nodiscard]] virtual std::optional<VelocityCommand> latest() noexcept = 0;

 protected:
  VelocityInput() = default;
  VelocityInput(const VelocityInput&) = default;
  VelocityInput& operator=(const VelocityInput&) = default;
  ~VelocityInput() = default;  // never owned through this interface
};

}  // namespace armature
