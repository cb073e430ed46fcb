// The limits along the path of a plan, as a grid for its law: the points of the path, close where its
// limits change fast, with the derivatives of joints and tool by the parameter.
//
// The joints come from the inverse kinematics, their derivatives from differences between points that are as far apart
// as the arm moves in a tick at the largest speed that is possible there. So a derivative means what the set-points
// show, also near a singularity. An interval is halved until the limits in its middle are the mean of those at its
// ends, within kResolution of what they permit, or until it is as short as two ticks. Where a path needs more points
// than the law has, the grid is coarser, and the check of the set-points slows the motion down.
//
// Each joint uses kJointShare of what the check of the set-points allows (PathCheck::kCheckedShare), so that this check
// usually finds no excess.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/kinematics/arm.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/law/speed_law.hpp"

namespace armature {

class LawGrid {
 public:
  static constexpr double kJointShare = 0.99;
  static constexpr double kResolution = 0.02;
  // kToolOnly: without the joints and the inverse kinematics: what the path would take if every joint could follow.
  enum class With : std::uint8_t { kToolOnly, kJoints };
  enum class Progress : std::uint8_t { kWorking, kDone };

  // Robot and arm must outlive the grid.
  LawGrid(const RobotModel& robot, const Arm& arm) noexcept;

  // Starts with the plan, whose corners are laid out and whose length is not 0, and empties `law`. Both must be the
  // same for all step()s.
  void begin(const CartesianPlan& plan, SpeedLaw& law, With with) noexcept;
  // Continues where the last grid with joints ended: at the end of segment `last`, the last one of the plan at that
  // time. `law` has lost the points behind `keep_s`, which is on that segment and is no place of an older corner.
  void extend(const CartesianPlan& plan, SpeedLaw& law, std::size_t last, double keep_s) noexcept;
  // Whether `law` has room for the segments behind `last` of a plan that continues another one: false for arcs of many
  // turns.
  [[nodiscard]] static bool has_room_behind(const CartesianPlan& plan, const SpeedLaw& law, std::size_t last) noexcept {
    return law.size() + first_points(plan, last + 1) + kSparePoints <= SpeedLaw::kMaxPoints;
  }
  // Fills `law` by an interval or by a few points. kDone: the grid is complete.
  Progress step(const CartesianPlan& plan, SpeedLaw& law) noexcept;
  // The joint whose speed or acceleration is nearest to its limit at a point of a law, where the square of the speed is
  // x and the acceleration u.
  struct Busiest {
    std::size_t axis = 0;
    double share = 0.0;  // of the limit
  };
  [[nodiscard]] Busiest busiest(const LawLimits& limits, double x, double u) const noexcept;
  // About the largest x that the joints permit at a point: their speed, the bend of the path, and their acceleration
  // over `length` of the path.
  [[nodiscard]] double most_of_joints(const LawLimits& limits, double length) const noexcept;

  // The smallest |sin(theta_5)| of all points so far that are not on a bend; 1 without the joints.
  [[nodiscard]] double least_wrist() const noexcept { return least_wrist_; }

  // Inverse kinematics computed by the last step().
  [[nodiscard]] int inverses() const noexcept { return inverses_; }

 private:
  struct Point {
    double s = 0.0;
    JointAngles joints{};
    PerAxis<double> slope{}, bend{};  // first and second derivative of the joints by s
    double bend_noise = 0.0;          // rounding of bend
    LawLimits limits{};
    double square = 0.0;  // largest x that each limit by itself permits
    double wrist = 1.0;   // Arm::wrist_sine(), 0 on a bend
    bool found = true;  // the inverse kinematics has a solution here and beside; if not, the check will refuse the path
  };
  // A part of the path without a break in its derivatives and its limits: half of a corner, or what is between corners.
  enum class Part : std::uint8_t { kBetween, kFirstHalf, kSecondHalf };
  struct Piece {
    std::size_t segment = 0;  // the first one of a corner
    Part part = Part::kBetween;
    double from = 0.0, to = 0.0;
    bool open_before = false, open_after = false;  // the derivatives continue beyond its ends
  };
  // Where two segments meet without a corner: the jumps of the direction and of the rotation per mm.
  struct Kink {
    double move = 0.0, turn_per_mm = 0.0;
    PathLimits most{};  // the larger ones of the two segments
  };
  static constexpr std::size_t kDepth = 48;

 public:
  // The most points of a segment and its corner before its intervals are halved, in plans that continue another one.
  static constexpr std::size_t kWindowPoints = 20;
  // So many points of the law are left for the passes over it.
  static constexpr std::size_t kSparePoints = 512;

 private:
  void begin_piece(const CartesianPlan& plan, SpeedLaw& law) noexcept;
  [[nodiscard]] bool next_piece(const CartesianPlan& plan) noexcept;
  void append(SpeedLaw& law, const Point& point, bool stops) noexcept;
  // The segment whose limits apply on the piece.
  [[nodiscard]] const CartesianSegment& owner(const CartesianPlan& plan) const noexcept;
  void add_jerk(LawLimits::Jerk& jerk, const Point& point) const noexcept;
  void add_jolt(SpeedLaw& law, Point& point) const noexcept;
  [[nodiscard]] Point point_at(const CartesianPlan& plan, double s, const JointAngles& near) noexcept;
  void differentiate(const CartesianPlan& plan, Point& point, double delta) noexcept;
  [[nodiscard]] JointAngles joints_at(const CartesianPlan& plan, double s, const JointAngles& near) noexcept;
  [[nodiscard]] LawLimits tool_limits(const CartesianPlan& plan, double s) const noexcept;
  [[nodiscard]] bool fine(const Point& a, const Point& middle, const Point& b) const noexcept;
  void pass_smoothly(const CartesianPlan& plan, Point& before, Point& after) const noexcept;
  void leave_room(const Kink& kink, Point& before, Point& after) const noexcept;
  void keep_speed_between(SpeedLaw& law, Point& middle, Point& end) const noexcept;
  [[nodiscard]] static int joint_intervals(const CartesianPlan& plan, std::size_t segment) noexcept;
  // The most points of the segments from `first` on, before their intervals are halved.
  [[nodiscard]] static std::size_t first_points(const CartesianPlan& plan, std::size_t first) noexcept;
  [[nodiscard]] int first_intervals(const CartesianPlan& plan) const noexcept;
  [[nodiscard]] bool has_room(const CartesianPlan& plan, const SpeedLaw& law) const noexcept;

  const RobotModel& robot_;
  const Arm& arm_;
  PerAxis<double> speed_rad_s_{}, accel_rad_s2_{}, jerk_rad_s3_{};
  With with_ = With::kJoints;
  Piece piece_{};
  double run_length_ = 0.0;            // of the parameter, between the stops before and after the piece
  JointAngles piece_joints_{};         // at the start of the piece
  Point last_{};                       // the last one of the law
  std::array<Point, kDepth> ahead_{};  // ends of intervals that begin at the one before, the nearest last
  std::size_t ahead_count_ = 0;
  int left_ = 0;  // intervals of the piece that are not ahead yet
  int intervals_ = 1;
  int inverses_ = 0;
  bool found_ = true;  // all solutions for the present point
  double least_wrist_ = 1.0;
};

}  // namespace armature
