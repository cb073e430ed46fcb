// Changing the rate along a path: within the joints' limits, on the path, as soon as they allow.
#include "controller/trajectory/run/path_clock.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "controller/base/timebase.hpp"
#include "controller/robot/axis_units.hpp"
#include "controller/trajectory/profile/scurve.hpp"
#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature {
namespace {

using Joints = PerAxis<Radians>;
using Path = std::function<Joints(double)>;  // of ticks

constexpr double kRounding = 2e-6;
constexpr double kOffPath_rad = 1e-10;  // while the rate should change

constexpr auto kNoTool = [](double, double) { return ToolStep{}; };
constexpr auto kAlways = [] { return true; };
constexpr auto kFullJerk = [](double, double) { return 1.0; };  // the plan may need all of it at any time

// Runs a clock and looks at every set-point with its own arithmetic.
class Drive {
 public:
  Drive(const RobotModel& robot, Path path, double rate = 1.0)
      : robot_{robot}, path_{std::move(path)}, clock_{robot}, points_{path_(0.0), path_(0.0)} {
    clock_.restart(rate);
  }

  void tick(double wanted) {
    const double time = clock_.time(), rate = clock_.rate();
    int evaluations = 0;
    const auto at = [&](double ticks) {
      ++evaluations;
      return path_(ticks);
    };
    const Joints next = clock_.advance(wanted, points_.back(), at, kNoTool, kAlways, kFullJerk);
    most_evaluations = std::max(most_evaluations, evaluations);
    last_evaluations = evaluations;
    ASSERT_GE(clock_.rate(), 0.0);
    ASSERT_LE(clock_.rate(), 1.0);
    ASSERT_EQ(clock_.time(), time + clock_.rate());
    expect_on_path(next, wanted == rate ? 0.0 : kOffPath_rad);
    points_.push_back(next);
    if (check_limits) expect_limits();
  }
  void ticks(int count, double wanted) {
    for (int i = 0; i < count && !testing::Test::HasFatalFailure(); ++i) tick(wanted);
  }

  [[nodiscard]] const PathClock& clock() const { return clock_; }
  [[nodiscard]] const Joints& now() const { return points_.back(); }
  [[nodiscard]] const std::vector<Joints>& points() const { return points_; }

  bool check_limits = true;
  int most_evaluations = 0;
  int last_evaluations = 0;

 private:
  void expect_on_path(const Joints& next, double most_rad) const {
    if (clock_.rate() == 0.0) {
      ASSERT_EQ(next, points_.back());
      return;
    }
    const Joints exact = path_(clock_.time());
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double miss_rad = (next[axis] - exact[axis]).value();
      ASSERT_LE(std::fabs(miss_rad), most_rad) << "axis " << axis + 1 << " is off the path";
    }
  }
  void expect_limits() const {
    const std::size_t k = points_.size() - 1;
    for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) {
      const double step = (points_[k][axis] - points_[k - 1][axis]).value();
      const double before = (points_[k - 1][axis] - points_[k - 2][axis]).value();
      const double speed = std::fabs(step) / kTickSeconds;
      const double accel = std::fabs(step - before) / (kTickSeconds * kTickSeconds);
      ASSERT_LE(speed, AxisUnits{robot_.axes[axis]}.max_speed_rad_s() * (1.0 + kRounding)) << "axis " << axis + 1;
      ASSERT_LE(accel, robot_.axes[axis].max_accel_rad_s2 * (1.0 + kRounding))
          << "axis " << axis + 1 << " at path time " << clock_.time() << ", rate " << clock_.rate();
    }
  }

  RobotModel robot_;
  Path path_;
  PathClock clock_;
  std::vector<Joints> points_;
};

// All joints alike, at a constant speed.
Path ramp(double rad_per_tick) {
  return [=](double ticks) {
    Joints joints;
    joints.fill(Radians{rad_per_tick * ticks});
    return joints;
  };
}

const RobotModel kRobot = test::paper_robot();
const double kStep = 120.0 * test::kDeg * kTickSeconds;                 // of a joint at full speed in a tick
const double kBend = 600.0 * test::kDeg * kTickSeconds * kTickSeconds;  // of axes 1 to 5, largest

TEST(PathClock, EvaluatesThePathOnceATickWhileTheRateIsTheOneWanted) {
  for (const double rate : {1.0, 0.37, 0.01}) {
    Drive run{kRobot, ramp(2e-4 * kStep), rate};
    run.ticks(100, rate);
    EXPECT_EQ(run.most_evaluations, 1);
    EXPECT_DOUBLE_EQ(run.clock().time(), 100.0 * rate);
  }
}

TEST(PathClock, EvaluatesNothingWhileStanding) {
  Drive run{kRobot, ramp(1e-4 * kStep), 1.0};
  run.ticks(100, 0.0);
  ASSERT_EQ(run.clock().rate(), 0.0);
  run.tick(0.0);
  EXPECT_EQ(run.last_evaluations, 0);
}

TEST(PathClock, BrakesInTheCruiseWithAllThatTheSlowestJointHas) {
  Drive run{kRobot, ramp(kStep), 1.0};
  run.check_limits = false;  // this path starts with a jump of speed
  run.tick(1.0);
  run.check_limits = true;
  const double from = run.clock().time();
  int braking = 0;
  for (; run.clock().rate() > 0.0 && braking < 10'000; ++braking) run.tick(0.0);
  const double needed = kStep / kBend;  // v / a
  EXPECT_NEAR(braking, needed, 2.0);
  EXPECT_NEAR(run.clock().time() - from, needed / 2.0, 1.0);  // v^2 / 2a, at v
}

TEST(PathClock, SpeedsUpInTheCruiseWithAllThatTheSlowestJointHas) {
  Drive run{kRobot, ramp(kStep), 0.0};
  int ticks = 0;
  for (; run.clock().rate() < 1.0 && ticks < 10'000; ++ticks) run.tick(1.0);
  EXPECT_NEAR(ticks, kStep / kBend, 2.0);
  run.tick(1.0);
  EXPECT_EQ(run.last_evaluations, 1);
}

TEST(PathClock, ReachesTheRateThatIsWantedExactly) {
  Drive run{kRobot, ramp(kStep), 0.0};
  for (const double wanted : {0.5, 0.01, 1.0, 0.3333, 0.0, 0.7}) {
    run.ticks(5'000, wanted);
    EXPECT_EQ(run.clock().rate(), wanted);
  }
}

TEST(PathClock, KeepsTheRateWhereAJointAlreadyBrakesWithAllItHas) {
  // From full speed down to rest with the largest deceleration, and standing from then on.
  const double stop = kStep / kBend;
  Drive run{kRobot, [=](double ticks) {
              const double t = std::min(ticks, stop);
              Joints joints{};
              joints[2] = Radians{kStep * t - 0.5 * kBend * t * t};
              return joints;
            }};
  run.check_limits = false;
  run.tick(1.0);
  run.check_limits = true;
  for (int tick = 1; tick < static_cast<int>(0.95 * stop); ++tick) {
    run.tick(0.0);
    ASSERT_NEAR(run.clock().rate(), 1.0, 1e-4) << "tick " << tick;
  }
}

TEST(PathClock, WaitsWithBrakingForAJointThatTurnsRound) {
  // Joint 3 turns with 95 % of its acceleration, while joint 1 would like to brake.
  Drive run{kRobot, [=](double ticks) {
              const double t = ticks - 300.0;
              Joints joints{};
              joints[0] = Radians{0.2 * kStep * ticks};
              joints[2] = Radians{0.5 * 0.95 * kBend * t * t};
              return joints;
            }};
  run.check_limits = false;
  run.tick(1.0);
  run.check_limits = true;
  run.ticks(3'000, 0.0);
  EXPECT_EQ(run.clock().rate(), 0.0);
  EXPECT_GT(run.clock().time(), 300.0);
  EXPECT_LT(run.clock().time(), 650.0);
}

// Sums of sines through whose extrema the joints turn, at up to 99 % of the limits, as a planner's check leaves them.
Path wild_path(test::Random& random, const RobotModel& robot) {
  struct Wave {
    double size, frequency, phase;
  };
  std::vector<std::vector<Wave>> waves(kAxes);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (random.integer(0, 5) == 0) continue;
    double speed = 0.0, accel = 0.0;
    for (auto count = random.integer(1, 3); count > 0; --count) {
      const double frequency = std::pow(10.0, random.real(-4.0, -1.5));  // per tick
      const double size = std::pow(10.0, random.real(-1.0, 0.0)) / frequency;
      waves[axis].push_back({size, frequency, random.real(0.0, 6.0)});
      speed += size * frequency;
      accel += size * frequency * frequency;
    }
    const double max_speed = AxisUnits{robot.axes[axis]}.max_speed_rad_s() * kTickSeconds;
    const double max_accel = robot.axes[axis].max_accel_rad_s2 * kTickSeconds * kTickSeconds;
    const double scale = 0.99 * std::min(max_speed / speed, max_accel / accel);
    for (Wave& wave : waves[axis]) wave.size *= scale;
  }
  return [waves](double ticks) {
    Joints joints{};
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      for (const auto& [size, frequency, phase] : waves[axis]) {
        joints[axis] += Radians{size * std::sin(frequency * ticks + phase)};
      }
    }
    return joints;
  };
}

TEST(PathClock, KeepsEveryLimitOnWildPathsWheneverTheRateChanges) {
  constexpr std::uint64_t kSeed = 11;
  test::Random random{kSeed};
  int most_evaluations = 0, stops = 0;
  for (int draw = 0; draw < test::draws(60); ++draw) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", draw " + std::to_string(draw));
    const RobotModel robot = random.integer(0, 1) == 0 ? test::paper_robot() : test::fine_robot();
    Drive run{robot, wild_path(random, robot), 0.0};
    for (int change = 0; change < 12; ++change) {
      const double choices[] = {0.0, 0.0, 0.01, 1.0, 1.0, random.real(0.01, 1.0)};
      run.ticks(static_cast<int>(random.integer(1, 800)), choices[random.integer(0, 5)]);
      if (HasFatalFailure()) return;
      stops += run.clock().rate() == 0.0 ? 1 : 0;
    }
    run.ticks(12'000, 1.0);
    if (HasFatalFailure()) return;
    EXPECT_GT(run.clock().rate(), 0.5) << "never speeds up again";
    most_evaluations = std::max(most_evaluations, run.most_evaluations);
  }
  EXPECT_GT(stops, test::draws(50));
  EXPECT_LE(most_evaluations, PathClock::kMaxEvaluations);
  RecordProperty("most_evaluations", most_evaluations);
}

// Such paths occur: chords from where the arm stands show a smaller speed than the path has there, by some per cent at
// first and less from attempt to attempt, but always by more than rounding.
TEST(PathClock, LeavesAStandstillOnAnyCurve) {
  for (const double curvature : {0.0, 0.01, 0.1, 0.3, 0.4877}) {
    for (const double speed : {0.5, 1.5, 6.6242, 40.0}) {
      const Path slowing = [=](double ticks) {
        Joints joints;
        joints.fill(Radians{kBend * (speed * ticks - curvature * ticks * ticks)});
        return joints;
      };
      Drive run{kRobot, slowing, 0.0};
      run.ticks(20, 1.0);
      EXPECT_GT(run.clock().rate(), 0.0) << speed << " " << curvature;
      EXPECT_GT(run.clock().time(), 0.0) << speed << " " << curvature;
    }
  }
}

// S-curves without a cruise, whose acceleration is largest where they are fast, held and slowed down anywhere.
TEST(PathClock, TheJerkOfAnSCurveIsEnoughWheneverTheRateChanges) {
  constexpr double kJerk = 1e3;
  RobotModel strong = kRobot;
  for (AxisModel& axis : strong.axes) {
    axis.max_accel_rad_s2 *= 1e3;
    axis.max_jerk_rad_s3 = kJerk;
  }
  const SCurveProfile law = plan_scurve(0.02, {.speed = 1e3, .accel = 1e6, .jerk = kJerk});
  constexpr double kTick3 = kTickSeconds * kTickSeconds * kTickSeconds;

  const Path path = [&](double ticks) {
    Joints joints;
    joints.fill(Radians{position(law, ticks * kTickSeconds)});
    return joints;
  };
  double most = 0.0;
  const auto duration = static_cast<int>(law.duration_s / kTickSeconds);
  for (int change = 1; change < duration; change += 25) {
    for (const double wanted : {0.0, 0.4}) {
      PathClock clock{strong};
      clock.restart(1.0, RateJerk::kMonotonic);
      std::vector<double> q(4, 0.0);
      Joints now = path(0.0);
      for (int tick = 0; clock.time() < duration && tick < 4 * duration; ++tick) {
        now = clock.advance(tick < change || tick > change + duration ? 1.0 : wanted, now, path, kNoTool, kAlways,
                            kFullJerk);
        q.push_back(now[0].value());
        const std::size_t k = q.size() - 1;
        most = std::max(most, std::fabs(q[k] - 3.0 * q[k - 1] + 3.0 * q[k - 2] - q[k - 3]) / (kJerk * kTick3));
      }
    }
  }
  EXPECT_LE(most, 1.05);
  EXPECT_GT(most, 0.99);
  RecordProperty("most", std::to_string(most));
}

TEST(PathClock, TheNumberOfEvaluationsIsBoundedWhateverThePathDoes) {
  constexpr std::uint64_t kSeed = 12;
  test::Random random{kSeed};
  // Jumps about: nothing that the model foretells is true, and only the rate before can be kept.
  PathClock clock{kRobot};
  clock.restart(0.5);
  int most = 0;
  Joints now{};
  for (int tick = 0; tick < 1'000; ++tick) {
    int evaluations = 0;
    const auto anywhere = [&](double) {
      ++evaluations;
      Joints joints;
      for (Radians& joint : joints) joint = Radians{random.real(-1.0, 1.0)};
      return joints;
    };
    now = clock.advance(tick % 2 == 0 ? 0.0 : 1.0, now, anywhere, kNoTool, kAlways, kFullJerk);
    most = std::max(most, evaluations);
    ASSERT_GE(clock.rate(), 0.0);
    ASSERT_LE(clock.rate(), 1.0);
  }
  EXPECT_LE(most, PathClock::kMaxEvaluations);
}

TEST(PathClock, JointsThatTheArmHasNotDoNotCount) {
  RobotModel robot = kRobot;
  robot.axis_count = 5;
  robot.axes[5].max_speed_rad_s = robot.axes[5].max_accel_rad_s2 = 0.0;
  Drive run{robot,
            [](double ticks) {
              Joints joints{};
              joints[0] = Radians{0.5 * kStep * ticks};
              return joints;
            },
            0.0};
  run.ticks(3'000, 1.0);
  EXPECT_EQ(run.clock().rate(), 1.0);
  run.ticks(3'000, 0.0);
  EXPECT_EQ(run.clock().rate(), 0.0);
}

}  // namespace
}  // namespace armature
