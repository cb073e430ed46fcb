#include "tests/bench/opw_arm.hpp"

#include <benchmark/benchmark.h>
#include <opw_kinematics/opw_kinematics.h>

#include <numbers>
#include <vector>

namespace armature::bench {

struct OpwArm::Samples {
  opw_kinematics::Parameters<double> arm;
  std::vector<std::array<double, 6>> joints;
  std::vector<opw_kinematics::Transform<double>, Eigen::aligned_allocator<opw_kinematics::Transform<double>>> poses;
};

OpwArm::OpwArm() : samples_{std::make_unique<Samples>()} {
  auto& arm = samples_->arm;
  arm.a2 = -70;
  arm.c1 = 290;
  arm.c2 = 270;
  arm.c3 = 302;
  arm.c4 = 72;
  arm.offsets[2] = -0.5 * std::numbers::pi;
}
OpwArm::OpwArm(OpwArm&&) noexcept = default;
OpwArm::~OpwArm() = default;

void OpwArm::add(const std::array<double, 6>& joints_rad) {
  samples_->joints.push_back(joints_rad);
  samples_->poses.push_back(opw_kinematics::forward(samples_->arm, joints_rad));
}

OpwArm::Solutions OpwArm::inverse(std::size_t sample) const {
  return opw_kinematics::inverse(samples_->arm, samples_->poses[sample]);
}

void OpwArm::forward(std::size_t sample) const {
  benchmark::DoNotOptimize(opw_kinematics::forward(samples_->arm, samples_->joints[sample]));
}

}  // namespace armature::bench
