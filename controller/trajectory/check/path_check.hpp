// Checks every set-point of a Cartesian plan, in order, and finds what must be slower and by how much.
//
// Speed, acceleration and jerk of the joints are first, second and third differences of the set-points over ticks,
// including rest before and after: exactly what the drives get. Limits are those of the axes (including the 4 Mpps of
// the pulse generators) times kCheckedShare, because set-points that a hold or an override shifts between ticks differ
// slightly and must be inside the limits too. Jerk is checked where all active segments are S-curves and the axis has a
// limit.
//
// Between ticks kink_check.hpp adds set-points where time laws have kinks. A joint that turns round near a limit moves
// up to a_max Ts^2 / 8 beyond its positions at the ticks, so it must keep that distance. Where the wrist singularity is
// passed (FollowedTool), joints 4 and 6 depend on the position of the ticks. Their accelerations there are at most 1.8
// times those at any other position of the ticks, and their jerks 3.1 times. So at ticks they may use half and 0.3 of
// the limits.
//
// The tool itself is checked as well, at every tick and half-way between ticks, its acceleration at kinks of time laws
// at every quarter of a tick. Its rotation is limited_turn().
//
// The check finds where along the path the motion must be slower (take_latest()).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/check/checked_limits.hpp"

namespace armature {

class PathCheck {
 public:
  static constexpr double kCheckedShare = CheckedLimits::kShare;
  // Rounding in the first and second differences of tool positions is far below these shares of a limit; of a very slow
  // tool it is below kRounding, mm or rad in a tick.
  static constexpr double kSpeedTolerance = 1e-6;
  static constexpr double kRounding = 1e-12;
  static constexpr double kToolTolerance = 1e-3;
  static constexpr double kJerkTolerance = 0.01;

  explicit PathCheck(const RobotModel& robot) noexcept;

  // The arm rests at the start of a plan.
  void begin(const JointAngles& joints, const ToolSample& tool) noexcept;
  // Continues behind a later tick, at which the arm is here. The differences of the next three ticks mean nothing.
  void restart(std::int64_t tick, const JointAngles& joints, const ToolSample& tool) noexcept;
  // The set-point one tick later. `through_wrist`: of FollowedTool.
  void add(const CartesianPlan& plan, const JointAngles& joints, const ToolSample& tool,
           bool through_wrist = false) noexcept;
  // The tool half a tick before the set-point of the last add(). At a change of its rate a plan is executed between
  // ticks, too.
  void add_tool_between(const CartesianPlan& plan, const ToolSample& tool) noexcept;
  // Four set-points between ticks, one tick apart, the newest first; the newest is at `tick`.
  void add_between(const CartesianPlan& plan, double tick, const std::array<JointAngles, 4>& joints) noexcept;
  // The same for the tool, whose acceleration is checked: three samples one tick apart, the newest first.
  void add_tool_between(const CartesianPlan& plan, double tick, const std::array<ToolSample, 3>& tool) noexcept;
  // Call after the last set-point: the arm rests.
  void finish(const CartesianPlan& plan) noexcept;

  // The excess that was found since the last call, and the ticks of the plan that it is about. The
  // path there must be executed `stretch` times as slowly.
  struct Place {
    double stretch = 1.0;
    std::uint8_t axis = 0;  // 1..6; 0: the tool
    double from_tick = 0.0, to_tick = 0.0;
  };
  [[nodiscard]] Place take_latest() noexcept;

  // The largest third difference of a joint or the tool at the last set-point, also half a tick before it, as a share
  // of its limit; 0 where jerk is not limited.
  [[nodiscard]] double jerk_share() const noexcept { return jerk_share_; }

  // Joint 1..6 that left its limits, or may have left them, between the two set-points before the last; 0: none.
  [[nodiscard]] std::uint8_t axis_at_its_limit() const noexcept { return axis_at_its_limit_; }

 private:
  using ToolSamples = std::array<ToolSample, 4>;  // the newest first
  struct Excess {
    double stretch = 1.0;  // 1: slow enough
    std::uint8_t axis = 0;
  };
  static constexpr std::size_t kOrders = 3;  // speed, acceleration, jerk
  // The oldest sample of tool_between_ is three and a half ticks old.
  static constexpr std::size_t kOldest = kOrders + 1;

  struct Range {
    std::size_t first = 0;
    std::size_t last = 0;
  };
  [[nodiscard]] Range segments_around(const CartesianPlan& plan, std::size_t order) const noexcept;
  // Those between ticks in the last `order` ticks before `tick`; nothing if all are at rest.
  [[nodiscard]] static std::optional<Range> segments_between(const CartesianPlan& plan, std::size_t order,
                                                             double tick) noexcept;
  void check_joints(const CartesianPlan& plan, std::size_t order, const Range& around,
                    const PerAxis<double>& difference, double tick) noexcept;
  void check_wrist(const CartesianPlan& plan, bool through_wrist) noexcept;
  void check_turning_points(const CartesianPlan& plan) noexcept;
  static void check_tool(Excess& worst, const PathLimits& limits, std::span<const ToolSample> tool) noexcept;
  // The jerk, if all segments of the last `ticks` are S-curves. No sample may be older.
  void check_tool_jerk(Excess& worst, const CartesianPlan& plan, std::size_t ticks, const ToolSamples& tool) noexcept;
  [[nodiscard]] static PathLimits largest_limits(const CartesianPlan& plan, const Range& around) noexcept;
  [[nodiscard]] PathLimits limits_around(const CartesianPlan& plan, std::size_t order) const noexcept;
  static void record(Excess& worst, double stretch, std::size_t axis_number) noexcept;
  // `excess` of the ticks from - to.
  void note(const Excess& excess, double from_tick, double to_tick) noexcept;

  std::size_t axis_count_;
  std::array<PerAxis<double>, kOrders> limit_{};  // rad per tick, tick^2, tick^3

  std::int64_t tick_ = 0;
  JointAngles joints_{};
  std::array<PerAxis<double>, kOrders> difference_{};
  std::array<PerAxis<double>, 3> step_{};   // first differences of this tick and the two before
  std::array<PerAxis<double>, 4> accel_{};  // second differences of this tick and the three before
  PerAxis<double> lowest_{}, highest_{};    // rad; beyond these a joint must not turn round
  std::array<JointAngles, 2> before_{};     // joints one and two ticks ago
  std::int64_t wrist_until_ = -1;           // joints 4 and 6 have reduced limits up to this tick
  std::uint8_t axis_at_its_limit_ = 0;
  ToolSamples tool_{};          // of this tick and the three before
  ToolSamples tool_between_{};  // half a tick before these
  std::size_t oldest_ = 0;      // the oldest segment that a difference may still contain
  double jerk_share_ = 0.0;
  Place latest_{};
};

}  // namespace armature
