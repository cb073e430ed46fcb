// The six-axis arm of Vo 2021 (Table 2), a spherical wrist on an elbow arm: forward and closed-form inverse kinematics
// with all 8 branches, in Denavit-Hartenberg angles theta.
//
//   joint      1    2    3    4    5    6      base_T_flange = A1 A2 A3 A4 A5 A6, A_i = eq. (24)
//   a [mm]     a1   a2   a3   0    0    0      k = hypot(a3, d4): forearm, from axis 3 to the wrist centre
//   alpha      90   0    90  -90   90   0      phi = atan2(d4, a3)
//   d [mm]     d1   0    0    d4   0    d6     reach |a2 - k| .. a2 + k: from axis 2 to the wrist centre
//
// With theta_2 = 90 deg and all others 0 the upper arm points up and the forearm forward.
//
// Where the print of Vo 2021 is wrong (each shown in tests/controller/kinematics/errata_six_r_test.cpp):
//   (24)        entry (2,2) is c * cos(alpha), not c * sin(alpha)
//   (26), (27)  eight terms of the expanded rotation; the factored product is used here
//   (28)        its column 4 is the wrist centre, not the flange
//   (30), (31)  row 2: -s2 V11 + c2 V12; row 1: c23 V11 + s23 V12
//   (32), (33)  row 3: -s4 V31 + c4 V32; row 2: +V43
//   (39)        has a second solution, atan2(-p_y, -p_x); so has (43), theta_4 + 180 deg with -theta_5
//   (40)        is a copy of (45); theta_2 = atan2(V124, V114) +- the angle at axis 2
//   (41)        exceeds 1 by rounding at the reach limit, where acos is a NaN; here an atan2 of the triangle's sides
//
// The only state is the constant geometry, so both cores may use one object.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>

#include "controller/base/math.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/kinematics/jacobian.hpp"
#include "controller/kinematics/raw_solutions.hpp"
#include "controller/kinematics/six_r_posture.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/robot/arm_geometry.hpp"

namespace armature {

class SixR {
 public:
  // a2 > 0 and k > 0.
  explicit SixR(const ArmGeometry& geometry) noexcept;

  // base_T_flange, eq. (25) as R03 * R36. Angles within kLargestTheta_rad; the result is not finite far beyond.
  [[nodiscard]] Transform forward(const Theta& theta) const noexcept { return flange_at(posture(theta)); }
  [[nodiscard]] Transform flange_at(const SixRPosture& posture) const noexcept;

  // All branches. 8 where both shoulders reach, 4 where one does; one less for each flip pair that the wrist
  // singularity merges. forward() of each gives the pose back within 4e-15 (rotation) and 1e-12 of the reach, and
  // within 1e-9 (1e-9 of the reach) where `singular` or `clamped` say so. Free angles are those of `previous`:
  //   wrist, |sin theta_5| < 1e-9:   theta_4 = previous, theta_6 follows, flip +1 stands for both
  //   shoulder, wrist centre within 1e-9 (a2 + k) of axis 1:   theta_1 = previous, and previous + 180 deg
  //   folded, wrist centre within 1e-9 (a2 + k) of axis 2:   theta_2 = previous
  [[nodiscard]] RawSolutions inverse(const Transform& base_T_flange, const Theta& previous) const noexcept;

  // The same in two steps, for a choice that needs few wrists: joints 1 to 3 of all branches (the pose must be rigid
  // and the angles valid), and the branches of some of them. Returns how many branches it has set.
  struct Arms;
  [[nodiscard]] Arms arms(const Transform& base_T_flange, const Theta& previous) const noexcept;
  [[nodiscard]] static std::size_t add_wrists(const Arms& arms, std::size_t first, std::size_t count,
                                              double previous_theta4, std::span<RawBranch> branches) noexcept;

  // The branch of least max |theta_i - previous_i| (then least sum of squares) among those of the shoulder nearer to
  // `previous`: the nearest of all 8 as long as theta_1 turns by less than 90 deg. The other shoulder is never tried,
  // so a path that leaves the reach of this one is kUnreachable instead of a jump. Where |sin theta_5| < wrist_zone,
  // theta_4 is that of `previous` and theta_5 keeps its sign through 0, see Arm::track.
  static constexpr double kTrackingWristZone = 1e-7;
  static constexpr double kKeepTheta4 = 2.0;  // everywhere
  // `keep_elbow`: only the elbow whose theta_2 and theta_3 are nearer, however far the wrist has to turn.
  [[nodiscard]] RawTracking track(const Transform& base_T_flange, const Theta& previous,
                                  double wrist_zone = kTrackingWristZone, bool keep_elbow = false) const noexcept;

  // Joints 1 to 3 that bring `flange_p_mm`, a point in the frame of the flange, to `point_mm`, where joints 4 to 6 are
  // those of `previous`. As for track(): the nearest elbow, and the shoulder nearer to `previous`. kUnreachable also
  // where the point is closer to axis 1 than joints 4 to 6 hold it beside the plane of the arm.
  [[nodiscard]] RawTracking track_point(const Eigen::Vector3d& point_mm, const Eigen::Vector3d& flange_p_mm,
                                        const Theta& previous) const noexcept;

  // det J = a2 k sin(theta_3 - phi) r sin(theta_5), r the signed distance of the wrist centre from axis 1.
  [[nodiscard]] Jacobian jacobian(const Theta& theta) const noexcept;
  [[nodiscard]] Manipulability manipulability(const Theta& theta) const noexcept;
  [[nodiscard]] RawSides sides(const Theta& theta) const noexcept;
  // The same, where its sides() are known.
  [[nodiscard]] Manipulability manipulability(const Theta& theta, const RawSides& sides) const noexcept;

  [[nodiscard]] SixRPosture posture(const Theta& theta) const noexcept;
  // Joint rates [rad/s] for a velocity of the flange in the base frame: jacobian()^-1 in closed form. Not finite at a
  // singularity.
  [[nodiscard]] Theta rates(const SixRPosture& posture, const Eigen::Vector3d& v_mm_s,
                            const Eigen::Vector3d& w_rad_s) const noexcept;
  [[nodiscard]] Theta rates(const Theta& theta, const Eigen::Vector3d& v_mm_s,
                            const Eigen::Vector3d& w_rad_s) const noexcept {
    return rates(posture(theta), v_mm_s, w_rad_s);
  }

 private:
  class Arctangents;
  struct Shoulder;
  struct Triangle;
  struct Elbow;
  struct Hand;
  struct Wrist;

  [[nodiscard]] Eigen::Vector3d wrist_centre(const Transform& base_T_flange) const noexcept;
  [[nodiscard]] Shoulder shoulder(const Eigen::Vector3d& wrist, double previous_rad) const noexcept;
  [[nodiscard]] Triangle triangle(const Eigen::Vector3d& wrist, const Shoulder& shoulder) const noexcept;
  // The three arctangents of the elbow, and the elbow from them; `first` is the index of the first one.
  void add_elbow(Arctangents& turns, const Triangle& triangle) const noexcept;
  [[nodiscard]] Elbow elbow(const Arctangents& turns, std::size_t first, const Triangle& triangle,
                            double previous_rad) const noexcept;

  ArmGeometry geometry_;
  double forearm_mm_;      // k
  double phi_rad_;         // phi
  double longest_mm_;      // a2 + k
  double shortest_mm_;     // |a2 - k|
  double difference_mm2_;  // a2^2 - k^2
  double tolerance_mm_;    // 1e-9 (a2 + k)
};

}  // namespace armature
