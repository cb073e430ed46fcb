// Where a belt is expected, by samples that come in each tick, and by those of a camera that come late.
#include "controller/activity/conveyor/conveyor_belt.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "controller/base/timebase.hpp"

namespace armature {
namespace {

constexpr double kCount_mm = 1e-7;  // so fine that it does not show
constexpr double kAhead_s = 0.0213;
constexpr BeltCamera kCamera{.period = Ticks{400}, .dead_time = Ticks{830}};

struct Parabola {
  double velocity, accel;

  [[nodiscard]] AxisState at(double t_s) const {
    return {.position = t_s * (velocity + 0.5 * accel * t_s), .velocity = velocity + accel * t_s, .accel = accel};
  }
  [[nodiscard]] std::int64_t counts(Ticks tick) const { return std::llround(at(seconds(tick)).position / kCount_mm); }
};

// The camera's samples of two seconds, each in the tick in which it arrives.
template <class Judge>
void follow(const Parabola& parabola, const Judge& judge) {
  ConveyorBelt belt{kCount_mm, kAhead_s, ConveyorBelt::bandwidths_for(kCamera)};
  for (Ticks tick = kCamera.dead_time; tick < Ticks{40'000}; tick += Ticks{1}) {
    const Ticks taken = tick - kCamera.dead_time;
    if (taken.value() % kCamera.period.value() == 0) belt.measure(parabola.counts(taken), taken);
    belt.expect(tick);
    judge(tick, belt);
  }
}

TEST(ConveyorBelt, ExpectsAConstantAccelerationWithoutErrorThoughItsSamplesAreLate) {
  for (const Parabola parabola : {Parabola{150, 0}, Parabola{-80, 0}, Parabola{100, -120}}) {
    follow(parabola, [&](Ticks tick, const ConveyorBelt& belt) {
      if (tick < Ticks{30'000}) return;  // until the observer has forgotten the step at its first sample
      const AxisState coming = parabola.at(seconds(tick) + kAhead_s);
      ASSERT_NEAR(belt.expected().position, coming.position, 1e-3) << tick.value();
      ASSERT_NEAR(belt.expected().velocity, coming.velocity, 0.05) << tick.value();
      ASSERT_NEAR(belt.now_mm(), parabola.at(seconds(tick)).position, 1e-3) << tick.value();
    });
  }
}

// Joints follow it: its position is the integral of its velocity, also at a sample.
TEST(ConveyorBelt, ExpectsAContinuousMotionBetweenTheSamples) {
  AxisState before;
  follow({100, -120}, [&](Ticks tick, const ConveyorBelt& belt) {
    const AxisState now = belt.expected();
    if (tick > kCamera.dead_time) {
      const double mean = 0.5 * (before.velocity + now.velocity);
      ASSERT_NEAR(now.position - before.position, mean * kTickSeconds, 1e-9) << tick.value();
    }
    before = now;
  });
}

TEST(ConveyorBelt, HasNothingToExpectBeforeTheFirstSample) {
  ConveyorBelt belt{kCount_mm, kAhead_s, ConveyorBelt::bandwidths_for(kCamera)};
  for (Ticks tick{0}; tick < Ticks{10}; tick += Ticks{1}) belt.expect(tick, 1.0);
  EXPECT_EQ(belt.expected().position, 0.0);
  belt.measure(70'000'000, Ticks{2});
  belt.expect(Ticks{10});
  EXPECT_NEAR(belt.expected().position, 7.0, 1e-6);
  EXPECT_EQ(belt.expected().velocity, 0.0);
}

}  // namespace
}  // namespace armature
