// The ABB IRB 120 in the library opw_kinematics, behind an interface without Eigen (see kdl_arm.hpp). Only in builds
// with ARMATURE_OPW_DIR.
#pragma once

#include <array>
#include <cstddef>
#include <memory>

namespace armature::bench {

class OpwArm {
 public:
  using Solutions = std::array<std::array<double, 6>, 8>;  // a solution that does not exist contains NaNs

  OpwArm();
  OpwArm(OpwArm&&) noexcept;
  ~OpwArm();

  // Samples, in the library's types: what it computes of them later.
  void add(const std::array<double, 6>& joints_rad);
  [[nodiscard]] Solutions inverse(std::size_t sample) const;  // all branches of its pose; without limits and choice
  void forward(std::size_t sample) const;

 private:
  struct Samples;
  std::unique_ptr<Samples> samples_;
};

}  // namespace armature::bench
