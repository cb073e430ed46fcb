// The source of set-points that follows commanded velocities of the joints or of the tool: for jogging, or for a
// learned policy.
//
// Joints: each axis changes to its commanded velocity as fast as its limits of acceleration (and jerk) allow, and keeps
// it. At a soft limit it comes to rest exactly at the limit: an axis with a velocity is on the fastest motion to the
// limit in this direction, with the commanded speed as its speed limit. So it always has the way that it needs to stop.
//
// Tool: see tool_velocity.hpp; it moves from the tick after the command on. Where the tool cannot continue within the
// limits of the joints, the joints stop, and the command has no effect until another one comes. Jerk is limited for
// changes of the commanded velocity only: not where the joints slow down or stop.
//
// If no command comes for the time-out, all axes come to rest. Commands must be repeated, also equal ones: an equal
// command costs nothing but the time-out. A stop has priority until the arm is at rest; commands of that time have no
// effect.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/activity/jog/tool_velocity.hpp"
#include "controller/activity/jog/velocity_input.hpp"
#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/message/jog.hpp"
#include "controller/motion/set_point_source.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/state/axis_reach.hpp"

namespace armature {

struct VelocitySettings {
  VelocityManner manner{};  // until a command has one
  Ticks time_out{};         // > 0; of commands without one of their own
  Transform flange_T_tool{};
};

class VelocitySource final : public SetPointSource {
 public:
  // References must outlive the source.
  VelocitySource(const RobotModel& robot, const Arm& arm, VelocityInput& input,
                 const VelocitySettings& settings) noexcept;
  VelocitySource(const VelocitySource&) = delete;
  VelocitySource& operator=(const VelocitySource&) = delete;

  // SetPointSource. `wake` is set in the tick in which the arm comes to rest, `stopped` in answer to a kStop.
  const SetPoint& advance(Ticks tick) noexcept override;
  void reset_to(const PerAxis<Radians>& position) noexcept override;
  // A velocity is no move that could be cut short or reported.
  void cut_short(Ticks) noexcept override {}
  void cancel(Ticks tick) noexcept override;

  // Takes over an arm in motion. It comes to rest unless a command follows.
  void begin_from(const PerAxis<AxisState>& state) noexcept;

  // The state of motion at the last set-point: exact for joint velocities, otherwise that of state_after().
  [[nodiscard]] PerAxis<AxisState> state() const noexcept;
  [[nodiscard]] bool at_rest() const noexcept { return !any_moves(); }
  // True when all axes are at rest and no command wants motion.
  [[nodiscard]] bool done() const noexcept { return !stopping_ && !any_moves() && !wants_to_move(); }
  // Why it came to rest, or why it would if no command followed. Valid after the first command that was not a kStop.
  struct Ending {
    JogEnd how = JogEnd::kDuration;  // not kFault
    std::uint8_t axis = 0;           // as in JogEnded
  };
  [[nodiscard]] Ending ending() const noexcept { return ending_; }
  // How often commands stopped to come while an axis had a velocity.
  [[nodiscard]] std::uint32_t time_outs() const noexcept { return time_outs_; }
  // How often the tool could not continue, and the joints stopped each for itself.
  [[nodiscard]] std::uint32_t departures() const noexcept { return departures_; }

 private:
  struct Axis {
    PhaseLaw law{};
    std::int64_t ticks = 0;  // since the start of the law
    double wanted_rad_s = 0.0;
  };

  void accept(const VelocityCommand& command, Ticks tick) noexcept;
  void follow(std::size_t axis, double wanted_rad_s) noexcept;
  void stop_joints(const PerAxis<AxisState>& state) noexcept;
  void halt_all() noexcept;
  void expire() noexcept;
  [[nodiscard]] std::uint8_t axis_at_limit() const noexcept;
  void set_manner(const VelocityManner& manner) noexcept;
  void advance_tool() noexcept;
  void advance_joints() noexcept;
  void leave_tool() noexcept;
  [[nodiscard]] bool wants_to_move() const noexcept;
  [[nodiscard]] bool joints_move() const noexcept;
  [[nodiscard]] bool moves(const Axis& axis) const noexcept;
  [[nodiscard]] bool any_moves() const noexcept;

  const RobotModel& robot_;
  VelocityInput& input_;
  Ticks time_out_;  // of commands without one of their own
  ProfileKind profile_ = ProfileKind::kTrapezoid;
  PerAxis<TimeLawLimits> limits_{};
  PerAxis<Axis> axes_{};
  ToolVelocity tool_;
  bool follows_tool_ = false;                // otherwise axes_ determine the set-points
  std::optional<ToolTwist> next_twist_{};    // waits for the joints to come to rest
  std::optional<ToolTwist> failed_twist_{};  // cannot be followed from here
  Ticks expires_{};                          // the tick in which the latest command is too old
  bool stopping_ = false;
  Ending ending_{};
  std::uint32_t time_outs_ = 0;
  std::uint32_t departures_ = 0;
};

}  // namespace armature
