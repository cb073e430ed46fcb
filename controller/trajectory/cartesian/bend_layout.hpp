// Places the bends of a plan with a table (wrist_bend.hpp): where its path passes the wrist singularity.
//
// The approach of the hand, in the frame of the forearm, is a smooth curve in a plane, also through the singularity,
// which is its origin. The path is sampled, and each place where the curve is closest to the origin is found. A bend is
// placed there if the curve misses the origin by less than the orientation may deviate:
//   AtSingularity::kBend  orientation_tolerance_rad of the segment
//   otherwise             kHair_rad, a part of a pulse: joint 4 would turn as far, for no visible effect
// A bend begins and ends where axes 4 and 6 enclose kWidest_rad, so that the joints turn slowly. It is narrower where
// the orientation would deviate by more than it may. It never contains a stop, but may begin or end there.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/kinematics/arm.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"

namespace armature {

class BendLayout {
 public:
  static constexpr double kHair_rad = 1e-7;
  static constexpr double kWidest_rad = 0.2;
  enum class Progress : std::uint8_t { kWorking, kDone };

  // The arm must outlive this.
  explicit BendLayout(const Arm& arm) noexcept : arm_{arm} {}

  // True if the path may need a bend. `least_wrist`: the smallest |sin(theta_5)| among some points of the path.
  [[nodiscard]] static bool may_need(const CartesianPlan& plan, double least_wrist) noexcept;

  // The largest deviation of the orientation on a segment.
  [[nodiscard]] static double allowed_deviation(const CartesianSegment& segment) noexcept;

  // Starts with a plan whose corners are laid out.
  void begin(const CartesianPlan& plan) noexcept;
  // Processes the next sample of the path. kDone: the bends of the plan are complete.
  Progress step(CartesianPlan& plan) noexcept;
  // Inverse kinematics computed by the last step(), some hundred where it places a bend.
  [[nodiscard]] int inverses() const noexcept { return inverses_; }

 private:
  static constexpr int kSamples = 32;          // of a segment
  static constexpr std::size_t kHistory = 64;  // samples

  struct Sample {
    double s = 0.0;
    JointAngles joints{};
    Eigen::Vector2d approach = Eigen::Vector2d::Zero();  // Arm::approach_in_forearm()
  };
  // The part of the path around a place on which a bend may be. `rests`: the tool stands at that end.
  struct Room {
    double from = 0.0, to = 0.0;
    bool rests_before = false, rests_after = false;
    double tolerance_rad = 0.0;
  };

  [[nodiscard]] std::optional<Sample> sample(const CartesianPlan& plan, double s, const JointAngles& near) noexcept;
  void consider(CartesianPlan& plan, const Sample& next) noexcept;
  [[nodiscard]] Room room_around(const CartesianPlan& plan, double s) const noexcept;
  [[nodiscard]] bool find_closest(const CartesianPlan& plan, const Room& room, double& s, double& miss,
                                  double width) noexcept;
  [[nodiscard]] std::optional<Sample> find_edge(const CartesianPlan& plan, double closest, double limit,
                                                bool limit_rests, double angle) noexcept;
  [[nodiscard]] const JointAngles& joints_before(double s) const noexcept;
  [[nodiscard]] bool place(CartesianPlan& plan, const Room& room, double closest, double angle, Sample& last) noexcept;
  using BendEnds = std::array<BendEnd, WristBend::kJoints>;
  [[nodiscard]] BendEnds end_of_bend(const CartesianPlan& plan, const Sample& at, const Room& room,
                                     double step) noexcept;
  [[nodiscard]] bool within_tolerance(const CartesianPlan& plan, const WristBend& bend, const JointAngles& near,
                                      double tolerance_rad) noexcept;

  const Arm& arm_;
  std::size_t segment_ = 0;
  int index_ = 0;                           // of the next sample in the segment
  std::array<Sample, kHistory> history_{};  // a ring; before the first bend, or behind the last
  std::size_t samples_ = 0;                 // in the history since it was emptied
  double last_share_ = 0.0;                 // where on the last interval its chord was closest to the origin, 0..1
  int inverses_ = 0;
};

}  // namespace armature
