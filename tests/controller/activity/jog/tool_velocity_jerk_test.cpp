// The jerk of the tool, whatever commands of velocity come when.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "controller/activity/jog/velocity_source.hpp"
#include "controller/base/timebase.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

using test::kDeg;

// The arm follows commands until it is told otherwise.
class ToolJog final : public VelocityInput {
 public:
  ToolJog(const ToolVelocityLimits& limits, std::int64_t time_out)
      : source_{robot_,
                arm_,
                *this,
                {.manner = {.tool = limits}, .time_out = Ticks{time_out}, .flange_T_tool = flange_T_tool_}} {
    const PerAxis<Radians> start = test::degrees({10, 20, 10, 30, 50, -20});
    source_.reset_to(start);
    poses.assign(3, arm_.forward(start) * flange_T_tool_);
  }

  std::optional<VelocityCommand> latest() noexcept override { return std::exchange(next, std::nullopt); }
  void tool(const Eigen::Vector3d& move_mm_s, const Eigen::Vector3d& turn_rad_s = Eigen::Vector3d::Zero(),
            ToolTwist::Frame frame = ToolTwist::Frame::kBase) {
    next = VelocityCommand{.kind = VelocityCommand::Kind::kTool,
                           .tool = {.frame = frame, .move_mm_s = move_mm_s, .turn_rad_s = turn_rad_s}};
  }
  void tick() { poses.push_back(arm_.forward(source_.advance(Ticks{++ticks_}).position) * flange_T_tool_); }
  const VelocitySource& source() const { return source_; }

  std::optional<VelocityCommand> next;
  std::vector<Transform> poses;

 private:
  const RobotModel robot_ = test::irb120();
  const Arm arm_{robot_};
  const Transform flange_T_tool_{.position_mm = {0, 0, 100}};
  VelocitySource source_;
  std::int64_t ticks_ = 0;
};

// The largest acceleration and jerk of the tool between the set-points, in mm and rad. Those of the rotation are those
// of its velocity in the base.
struct Smoothness {
  double accel = 0.0, jerk = 0.0, turn_accel = 0.0, turn_jerk = 0.0;
};
Smoothness smoothness_of(const std::vector<Transform>& poses) {
  std::vector<Eigen::Vector3d> move, turn;
  for (std::size_t k = 1; k < poses.size(); ++k) {
    move.push_back((poses[k].position_mm - poses[k - 1].position_mm) / kTickSeconds);
    const Eigen::Matrix3d by = poses[k].rotation * poses[k - 1].rotation.transpose();
    turn.push_back(Eigen::Vector3d{by(2, 1) - by(1, 2), by(0, 2) - by(2, 0), by(1, 0) - by(0, 1)} /
                   (2.0 * kTickSeconds));
  }
  const auto second = [](const std::vector<Eigen::Vector3d>& v, std::size_t k) {
    return Eigen::Vector3d{v[k] - 2.0 * v[k - 1] + v[k - 2]}.norm() / (kTickSeconds * kTickSeconds);
  };
  Smoothness worst;
  for (std::size_t k = 2; k < move.size(); ++k) {
    worst.accel = std::max(worst.accel, (move[k] - move[k - 1]).norm() / kTickSeconds);
    worst.turn_accel = std::max(worst.turn_accel, (turn[k] - turn[k - 1]).norm() / kTickSeconds);
    worst.jerk = std::max(worst.jerk, second(move, k));
    worst.turn_jerk = std::max(worst.turn_jerk, second(turn, k));
  }
  return worst;
}

// It ends while the tool still accelerates.
TEST(ToolVelocityJerk, IsKeptByAShortJog) {
  ToolJog jog{
      {.accel_mm_s2 = 1'000.0, .turn_accel_rad_s2 = 10.0, .jerk_mm_s3 = 20'000.0, .turn_jerk_rad_s3 = 20'000.0 * kDeg},
      2'400};
  jog.tool({0, 0, -200});
  for (int i = 0; i < 20'000 && (i < 2 || !jog.source().at_rest()); ++i) jog.tick();
  const Smoothness worst = smoothness_of(jog.poses);
  EXPECT_TRUE(jog.source().at_rest());
  EXPECT_GT(worst.accel, 990.0);
  EXPECT_LE(worst.accel, 1'000.0 * 1.001);
  EXPECT_LE(worst.jerk, 20'000.0 * 1.01);
  EXPECT_LE(worst.turn_jerk, 1.0);
}

TEST(ToolVelocityJerk, IsKeptByRandomChangesOfAllVelocities) {
  constexpr double kMove = 60.0, kTurn = 0.3;
  test::Random random{920};
  for (int draw = 0; draw < 60; ++draw) {
    const ToolVelocityLimits limits{.accel_mm_s2 = random.real(200, 1'000),
                                    .turn_accel_rad_s2 = random.real(1, 4),
                                    .jerk_mm_s3 = random.real(5'000, 30'000),
                                    .turn_jerk_rad_s3 = random.real(20, 200)};
    ToolJog jog{limits, 100'000};
    const auto part = [&random](double most) {
      if (random.integer(0, 2) == 0) return Eigen::Vector3d{Eigen::Vector3d::Zero()};
      return Eigen::Vector3d{random.real(-most, most), random.real(-most, most), random.real(-most, most)};
    };
    for (int change = 0; change < 10; ++change) {
      const auto frame = random.integer(0, 1) == 0 ? ToolTwist::Frame::kBase : ToolTwist::Frame::kTool;
      const Eigen::Vector3d move = part(kMove), turn = part(kTurn);
      jog.tool(move, turn, frame);
      if (random.integer(0, 3) == 0) jog.next = VelocityCommand{.kind = VelocityCommand::Kind::kHalt};
      for (std::int64_t i = random.integer(1, 1'000); i > 0; --i) jog.tick();
    }
    ASSERT_EQ(jog.source().departures(), 0u) << "seed 920 draw " << draw;
    // In the frame of the tool a change turns with it: centripetal and Coriolis parts are beside the limits.
    const double w = 2.0 * kTurn, v = 2.0 * kMove, turn_accel = limits.turn_accel_rad_s2;
    const Smoothness worst = smoothness_of(jog.poses);
    EXPECT_LE(worst.accel, 1.01 * limits.accel_mm_s2 + w * v) << "seed 920 draw " << draw;
    EXPECT_LE(worst.jerk, 1.01 * limits.jerk_mm_s3 + 2.0 * w * limits.accel_mm_s2 + turn_accel * v + w * w * v)
        << "seed 920 draw " << draw;
    EXPECT_LE(worst.turn_accel, 1.01 * turn_accel + w * w) << "seed 920 draw " << draw;
    EXPECT_LE(worst.turn_jerk, 1.01 * limits.turn_jerk_rad_s3 + 3.0 * w * turn_accel + w * w * w)
        << "seed 920 draw " << draw;
  }
}

}  // namespace
}  // namespace armature
