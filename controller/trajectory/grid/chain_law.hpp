// The law of a plan: the limits along the path, the fastest law under them, and from it the table and the
// times of the segments.
//
// The law is planned twice: for the tool alone, which gives the time that each segment would take if the joints could
// follow, and with the joints. Where the check of the set-points finds an excess, the limits are lowered there and the
// law is planned again. The rest of the path keeps its speed. Where jerk is limited, the law is smoothed
// (smooth_law.hpp).
//
// In a plan that continues another one the grid of the common segments stays, so the law can begin with the speed of
// that plan. What a plateau or the check demands close behind the joint is taken back as far as the motion cannot brake
// to it. A segment counts as slowed down there by the largest share by which the joints limit the speed of its tool.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/base/timebase.hpp"
#include "controller/base/units.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/check/path_check.hpp"
#include "controller/trajectory/grid/law_grid.hpp"
#include "controller/trajectory/grid/smooth_law.hpp"
#include "controller/trajectory/law/speed_law.hpp"

namespace armature {

// The longest segment: 600 s. Where bounds do not show that its set-points keep the limits, these are computed one by
// one before the first is executed. So a longer segment could occupy core 1 for minutes.
inline constexpr Ticks kLongestSegment{std::int64_t{600} * kClkFreqHz / kTickCycles.value()};

class ChainLaw {
 public:
  // kTooLate: the plan that is to be continued is too fast for what follows.
  enum class Progress : std::uint8_t { kWorking, kSampled, kDone, kTooLate };

  // Robot and arm must outlive this.
  ChainLaw(const RobotModel& robot, const Arm& arm) noexcept : arm_{arm}, grid_{robot, arm} {}

  // Starts with a plan whose corners are laid out and whose length is not 0.
  void begin(const CartesianPlan& plan) noexcept;

  // The last plan is that of trapezoids, or its last motion is smooth.
  [[nodiscard]] bool can_continue() const noexcept { return !smooth_ || smooth_law_.can_continue(); }
  // The motion of the law of the plan, which can_continue(). It is the plan itself, or what is averaged to a smooth
  // plan; then it is ahead of the plan.
  struct LawMotion {
    const TimeTable& table;
    double later_s;  // the time of the plan is later by this, up to its end
  };
  [[nodiscard]] LawMotion motion(const CartesianPlan& plan) const noexcept;
  // tau of a smooth plan, which can_continue(); 0 for trapezoids.
  [[nodiscard]] double tau_s() const noexcept;
  // The place of the law of the last plan at which it is continued: where motion() is at `earliest_s` of the plan, or
  // the next point of the law in motion. Null if there is none.
  struct Joint {
    std::size_t point = 0;
    TimeTable::Point passing{};  // of motion(), with the time of the plan
  };
  [[nodiscard]] std::optional<Joint> joint_at(const CartesianPlan& plan, double earliest_s) noexcept;
  // Leaves the law from there on, and the table of the plan from `from_s` up to there; extend() continues with them.
  // The time is then counted from tick `origin` on. False, and nothing is changed: too many points of the table.
  [[nodiscard]] bool keep(CartesianPlan& plan, const Joint& joint, double from_s, Ticks origin) noexcept;
  // Whether there is room for the law of further segments behind `last`, which the plan has got.
  [[nodiscard]] bool has_room_behind(const CartesianPlan& plan, std::size_t last) const noexcept {
    return LawGrid::has_room_behind(plan, law_, last);
  }
  // Starts with a plan that got further segments behind `last`, and whose table keeps its part before the joint. The
  // path up to `keep_s` is that of the last plan.
  void extend(const CartesianPlan& plan, std::size_t last, double keep_s) noexcept;
  // The plan, or the one that it continues, has limits of jerk.
  [[nodiscard]] bool smooth() const noexcept { return smooth_; }
  // How many segments can be added to a plan that continues this one behind this time.
  [[nodiscard]] std::size_t room(const CartesianPlan& plan, double earliest_s) const noexcept;
  // kSampled, once: the joints along the path are known, and so is least_wrist(); continue. kDone: the table of the
  // plan is set, and start, duration and stretch of its segments.
  Progress step(CartesianPlan& plan) noexcept;
  // The cost of the last step(), in inverse kinematics. An interval of a law takes about as long as one.
  [[nodiscard]] int inverses() const noexcept { return inverses_; }

  // Of LawGrid.
  [[nodiscard]] double least_wrist() const noexcept { return grid_.least_wrist(); }

  // Slows down the part of the path that an excess is about. `share` <= 1 is added to what the excess demands.
  void lower(const CartesianPlan& plan, const PathCheck::Place& place, double share) noexcept;
  // Plans the law again after lower(). Continue with step().
  void plan_again() noexcept;

  // The joint that limits the speed of a segment for the longest time, and the point where that joint moves most per
  // path.
  struct Bottleneck {
    std::uint8_t axis = 0;  // 1..6; 0: the tool
    double s = 0.0;
  };
  [[nodiscard]] Bottleneck bottleneck(const CartesianPlan& plan, std::size_t segment) const noexcept;
  // The joints at a point of the path, to a flip of the wrist: followed from the start in kJointSteps steps.
  static constexpr int kJointSteps = 64;
  [[nodiscard]] JointAngles joints_at(const CartesianPlan& plan, double s) const noexcept;

 private:
  enum class Stage : std::uint8_t { kToolGrid, kToolLaw, kGrid, kLaw, kSmooth, kDone };
  static constexpr std::size_t kIntervals = 4;  // of the law in a step

  void measure(const CartesianPlan& plan, std::array<double, CartesianPlan::kMaxSegments>& time_s) const noexcept;
  // What follows when the law is planned: another pass, the smoothing or the end.
  [[nodiscard]] Progress end_law(CartesianPlan& plan) noexcept;

  // Sets the table of the plan, and start, duration and stretch of its segments.
  void finish(CartesianPlan& plan) noexcept;
  void set_table(CartesianPlan& plan) const noexcept;
  void set_stretch(CartesianPlan& plan, std::size_t segment) const noexcept;

  // The factor by which the joints limit the speed of a segment most, against the tool alone at the same place.
  [[nodiscard]] double most_slowed(const CartesianPlan& plan, std::size_t segment) const noexcept;

  const Arm& arm_;
  LawGrid grid_;
  SpeedLaw law_;
  SmoothLaw smooth_law_;
  bool smooth_ = false;  // the plan has limits of jerk
  Stage stage_ = Stage::kDone;
  // The points of a window are so close that few have to be added.
  static constexpr int kWindowRounds = 2;
  int rounds_ = SpeedLaw::kMaxRounds;
  bool lowered_ = false;
  double held_to_ = 0.0;  // up to here, the law keeps the speed that it has at the joint
  int inverses_ = 0;
  // Time of each segment without limits of jerk: with the tool's limits only, and with those of the joints.
  std::array<double, CartesianPlan::kMaxSegments> tool_s_{}, joint_s_{};
};

}  // namespace armature
