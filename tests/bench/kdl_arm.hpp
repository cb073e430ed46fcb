// A six-axis arm in Orocos KDL, behind an interface without Eigen: KDL's classes hold Eigen matrices, whose layout
// depends on how Eigen is compiled, and the controller compiles it in its own way.
#pragma once

#include <array>
#include <memory>

namespace armature::bench {

using KdlPose = std::array<double, 12>;  // rows of [rotation | position_mm]

// Standard Denavit-Hartenberg parameters; limits of theta.
struct KdlArmModel {
  std::array<double, 6> a_mm{}, alpha_rad{}, d_mm{};
  std::array<double, 6> lowest_rad{}, highest_rad{};
};

// Computes in metres, as KDL's tolerances (1e-6 for each inverse) expect.
class KdlArm {
 public:
  using Angles = std::array<double, 6>;

  explicit KdlArm(const KdlArmModel& model);
  KdlArm(KdlArm&&) noexcept;
  ~KdlArm();

  void forward(const Angles& theta, KdlPose& pose);  // ChainFkSolverPos_recursive
  // One solution, from `start`; false if none was found.
  bool newton(const KdlPose& pose, const Angles& start, Angles& found);               // ChainIkSolverPos_NR_JL
  bool levenberg_marquardt(const KdlPose& pose, const Angles& start, Angles& found);  // ChainIkSolverPos_LMA

 private:
  struct Solvers;
  std::unique_ptr<Solvers> solvers_;
};

}  // namespace armature::bench
