#include "controller/motion/axis_control.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/controller/support/robots.hpp"

namespace armature {
namespace {

// The set-points of an axis go to `share` of its following-error limit within 0.1 s and stay there. Its encoder stands
// still. Returns the pulses until the error is found, as a share of the limit.
double sent_until_error(double share, bool feedback) {
  constexpr int kRampTicks = 2'000, kEndTicks = 200'000;
  AxisModel model = test::paper_robot().axes[0];
  model.following_error_at_rest_rad = 0;
  const Radians limit{model.following_error_limit_rad};
  AxisControl control{model, feedback};
  control.restart(Pulses{0}, Counts{0});
  for (int tick = 1; tick <= kEndTicks; ++tick) {
    const Radians reference{limit.value() * share * std::min(tick, kRampTicks) / kRampTicks};
    control.tick_emitted(control.next(reference, Counts{0}));
    if (control.following_error(Radians{})) break;
  }
  return std::fabs(static_cast<double>(control.committed().value()) / AxisUnits{model}.to_exact_pulses(limit));
}

TEST(AxisControl, StopsACorrectionThatAnEncoderAtRestDoesNotEnd) {
  for (const double share : {0.01, 0.1, 0.5, 0.9}) {
    const double sent = sent_until_error(share, true);
    EXPECT_GT(sent, 1.0) << share;
    EXPECT_LT(sent, 1.2) << share;
  }
}

TEST(AxisControl, WithoutFeedbackLeavesAnAxisWithinItsLimitAlone) {
  EXPECT_NEAR(sent_until_error(0.9, false), 0.9, 1e-3);
}

}  // namespace
}  // namespace armature
