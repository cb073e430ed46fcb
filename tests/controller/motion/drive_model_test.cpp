#include "controller/motion/drive_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "controller/base/timebase.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

// The same drive integrated by Runge-Kutta in small steps, with the pulses spread evenly.
struct IntegratedDrive {
  double natural_rad_s;
  double damping;
  double sent = 0.0, x = 0.0, v = 0.0;

  void step(double count) {
    constexpr int kSteps = 200;
    const double h = kTickSeconds / kSteps;
    const double rate = count / kTickSeconds;
    const auto accel = [&](double r, double xx, double vv) {
      return natural_rad_s * natural_rad_s * (r - xx) - 2.0 * damping * natural_rad_s * vv;
    };
    for (int i = 0; i < kSteps; ++i) {
      const double r0 = sent, r1 = sent + 0.5 * h * rate, r2 = sent + h * rate;
      const double k1x = v, k1v = accel(r0, x, v);
      const double k2x = v + 0.5 * h * k1v, k2v = accel(r1, x + 0.5 * h * k1x, v + 0.5 * h * k1v);
      const double k3x = v + 0.5 * h * k2v, k3v = accel(r1, x + 0.5 * h * k2x, v + 0.5 * h * k2v);
      const double k4x = v + h * k3v, k4v = accel(r2, x + h * k3x, v + h * k3v);
      x += h / 6.0 * (k1x + 2.0 * k2x + 2.0 * k3x + k4x);
      v += h / 6.0 * (k1v + 2.0 * k2v + 2.0 * k3v + k4v);
      sent = r2;
    }
  }
};

TEST(DriveModel, IsExactForAnyBandwidthAndDamping) {
  for (const double natural_hz : {0.5, 40.0, 400.0, 4'000.0}) {
    for (const double damping : {0.3, 0.7, 1.0, 2.0}) {
      const double natural_rad_s = 2.0 * std::numbers::pi * natural_hz;
      DriveModel model{natural_rad_s, damping};
      IntegratedDrive integrated{natural_rad_s, damping};
      test::Random random{9};
      for (int tick = 0; tick < 500; ++tick) {
        const auto count = random.integer(-200, 200);
        model.step(Pulses{count});
        integrated.step(static_cast<double>(count));
        ASSERT_NEAR(static_cast<double>(model.sent().value()) - model.lag(), integrated.x, 1e-6)
            << natural_hz << " Hz, damping " << damping;
        ASSERT_NEAR(model.lag(), integrated.sent - integrated.x, 1e-6);
      }
    }
  }
}

TEST(DriveModel, LagsBehindAConstantSpeedByTwoDampingOverFrequency) {
  const double natural_rad_s = 2.0 * std::numbers::pi * 40.0;
  DriveModel model{natural_rad_s, 1.0};
  for (int tick = 0; tick < 20'000; ++tick) model.step(Pulses{8});
  EXPECT_NEAR(model.lag(), 8.0 / kTickSeconds * 2.0 / natural_rad_s, 1e-6);
}

TEST(DriveModel, ComesToRestWhereItWasSent) {
  DriveModel model{250.0, 1.0};
  model.restart(Pulses{1'000'000'000'000});
  for (int tick = 0; tick < 100; ++tick) model.step(Pulses{-200});
  model.subtract(Pulses{-5});
  for (int tick = 0; tick < 10'000; ++tick) model.step(Pulses{0});
  EXPECT_EQ(model.sent(), Pulses{1'000'000'000'000 - 20'000 + 5});
  EXPECT_NEAR(model.lag(), 0.0, 1e-9);
}

}  // namespace
}  // namespace armature
