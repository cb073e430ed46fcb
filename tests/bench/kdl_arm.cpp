#include "tests/bench/kdl_arm.hpp"

#include <cstddef>
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <kdl/chainiksolverpos_nr_jl.hpp>
#include <kdl/chainiksolvervel_pinv.hpp>

namespace armature::bench {
namespace {

constexpr unsigned kMaxIterations = 100;
constexpr double kTolerance = 1e-6;  // m and rad

KDL::Chain chain_of(const KdlArmModel& model) {
  KDL::Chain chain;
  for (std::size_t i = 0; i < 6; ++i) {
    chain.addSegment(KDL::Segment{KDL::Joint{KDL::Joint::RotZ},
                                  KDL::Frame::DH(1e-3 * model.a_mm[i], model.alpha_rad[i], 1e-3 * model.d_mm[i], 0.0)});
  }
  return chain;
}

void copy(const KdlArm::Angles& from, KDL::JntArray& to) {
  for (unsigned i = 0; i < 6; ++i) to(i) = from[i];
}

void copy(const KDL::JntArray& from, KdlArm::Angles& to) {
  for (unsigned i = 0; i < 6; ++i) to[i] = from(i);
}

KDL::JntArray joints_of(const KdlArm::Angles& angles) {
  KDL::JntArray joints{6};
  copy(angles, joints);
  return joints;
}

KDL::Frame frame_of(const KdlPose& p) {
  return {KDL::Rotation{p[0], p[1], p[2], p[4], p[5], p[6], p[8], p[9], p[10]},
          KDL::Vector{1e-3 * p[3], 1e-3 * p[7], 1e-3 * p[11]}};
}

}  // namespace

struct KdlArm::Solvers {
  explicit Solvers(const KdlArmModel& model)
      : chain{chain_of(model)}, lowest{joints_of(model.lowest_rad)}, highest{joints_of(model.highest_rad)} {}

  KDL::Chain chain;
  KDL::JntArray lowest, highest;
  KDL::JntArray start{6}, found{6};
  KDL::ChainFkSolverPos_recursive forward{chain};
  KDL::ChainIkSolverVel_pinv velocity{chain};
  KDL::ChainIkSolverPos_NR_JL newton{chain, lowest, highest, forward, velocity, kMaxIterations, kTolerance};
  // Its own weights count 1 rad as 1 cm, so it stops at 1e-4 rad.
  KDL::ChainIkSolverPos_LMA levenberg_marquardt{chain, Eigen::Matrix<double, 6, 1>::Ones(), kTolerance};
};

KdlArm::KdlArm(const KdlArmModel& model) : solvers_{std::make_unique<Solvers>(model)} {}
KdlArm::KdlArm(KdlArm&&) noexcept = default;
KdlArm::~KdlArm() = default;

void KdlArm::forward(const Angles& theta, KdlPose& pose) {
  copy(theta, solvers_->start);
  KDL::Frame frame;
  solvers_->forward.JntToCart(solvers_->start, frame);
  for (int row = 0; row < 3; ++row) {
    const auto first = static_cast<std::size_t>(4 * row);
    for (int column = 0; column < 3; ++column) pose[first + static_cast<std::size_t>(column)] = frame.M(row, column);
    pose[first + 3] = 1e3 * frame.p(row);
  }
}

bool KdlArm::newton(const KdlPose& pose, const Angles& start, Angles& found) {
  copy(start, solvers_->start);
  const int result = solvers_->newton.CartToJnt(solvers_->start, frame_of(pose), solvers_->found);
  copy(solvers_->found, found);
  return result >= 0;
}

bool KdlArm::levenberg_marquardt(const KdlPose& pose, const Angles& start, Angles& found) {
  copy(start, solvers_->start);
  const int result = solvers_->levenberg_marquardt.CartToJnt(solvers_->start, frame_of(pose), solvers_->found);
  copy(solvers_->found, found);
  return result >= 0;
}

}  // namespace armature::bench
