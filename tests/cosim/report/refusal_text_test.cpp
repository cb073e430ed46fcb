// Why a move was refused, in words.
#include "cosim/report/format/refusal_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "controller/kinematics/ik_result.hpp"

namespace armature::cosim {
namespace {

TEST(RefusalText, GivesTheNumbersOfEveryReason) {
  using Kind = PathProblem::Kind;
  const auto text = [](Refusal reason, const PathProblem& path) {
    return refusal_text({.reason = reason, .axis = 0, .path = path});
  };
  EXPECT_EQ(refusal_text({.reason = Refusal::kQueueFull}), "queue_full");
  EXPECT_EQ(text(Refusal::kUnreachable, {.kind = Kind::kUnreachable, .at = 0.87, .margin_mm = 12.34}),
            "unreachable by up to 12.3 mm from 87 % of the path on");
  EXPECT_EQ(
      text(Refusal::kOrientation, {.kind = Kind::kOrientation, .at = 1, .residual_rad = 0.0349065850398866}),
      "orientation off by 2 deg at the end of the path: five joints hold the hand in a vertical plane through axis "
      "1");
  EXPECT_EQ(
      text(Refusal::kSingular,
           {.kind = Kind::kTooFast, .at = 0.51, .axis = 4, .singular = kWristSingular | kElbowSingular, .stretch = 45}),
      "singular: joint 4 would need 45 times the time at 51 % of the path: wrist and elbow singularity");
  EXPECT_EQ(text(Refusal::kTooFast, {.kind = Kind::kTooFast, .at = 0, .axis = 1, .stretch = 21.5}),
            "too_fast: joint 1 would need 21.5 times the time at 0 % of the path");
  EXPECT_EQ(text(Refusal::kNoCircle, {.kind = Kind::kNoCircle}),
            "no_circle: the three points lie on a line or coincide, or the start is on the axis");
  EXPECT_EQ(text(Refusal::kNoSpline, {.kind = Kind::kNoSpline}),
            "no_spline: points of the spline are closer than 0.001 mm, or the curve turns back on the spot");
  EXPECT_EQ(text(Refusal::kOutputOutside, {.kind = Kind::kOutputOutside}),
            "output_outside: an output is before the start or behind the end of the path");
  EXPECT_EQ(text(Refusal::kConfiguration, {.kind = Kind::kNoConfiguration, .configuration = kElbowPart | kWristPart}),
            "configuration: no solution has the requested elbow and wrist");
  EXPECT_EQ(text(Refusal::kConfiguration,
                 {.kind = Kind::kOtherConfiguration, .segment = 1, .axis = 6, .configuration = kTurnsPart}),
            "configuration: the path of move 2 of its chain ends with another number of turns of joint 6 than "
            "requested; move the joints there first");
  EXPECT_EQ(text(Refusal::kInvalidTarget, {.kind = Kind::kTooLong}),
            "invalid_target: the path would take more than 600 s; make it faster or divide it");
}

TEST(RefusalText, SaysWhichAngleIsBeyondWhichLimit) {
  const auto text = [](const PathProblem& path) {
    return refusal_text({.reason = Refusal::kOutsideLimits, .axis = 2, .path = path});
  };
  using Kind = PathProblem::Kind;
  constexpr double kDeg = 0.017453292519943295;
  EXPECT_EQ(text({.at = 1, .angle_rad = 200 * kDeg, .limit_rad = 165 * kDeg}),
            "outside_limits, axis 2: target 200 deg is beyond 165 deg");
  EXPECT_EQ(text({.at = 1, .angle_rad = -110.001 * kDeg, .limit_rad = -110 * kDeg}),
            "outside_limits, axis 2: target -110.001 deg is beyond -110 deg");
  EXPECT_EQ(text({.at = 1, .angle_rad = 110.0000004 * kDeg, .limit_rad = 110 * kDeg}),
            "outside_limits, axis 2: target 110.0000004 deg is beyond 110 deg");
  EXPECT_EQ(text({.at = 1, .angle_rad = 1 * kDeg, .limit_rad = 0}),
            "outside_limits, axis 2: target 1 deg is beyond 0 deg");
  EXPECT_EQ(text({.at = 1, .angle_rad = 1 * kDeg, .limit_rad = -2 * kDeg}),
            "outside_limits, axis 2: target 1 deg is beyond -2 deg");
  EXPECT_EQ(text({.at = 0, .angle_rad = 171.2 * kDeg, .limit_rad = 165 * kDeg}),
            "outside_limits, axis 2: no room to brake, 171.2 deg is beyond 165 deg");
  EXPECT_EQ(text({.kind = Kind::kOutsideLimits,
                  .segment = 2,
                  .at = 0.5,
                  .axis = 2,
                  .angle_rad = 165.25 * kDeg,
                  .limit_rad = 165 * kDeg}),
            "outside_limits, axis 2 at 50 % of the path of move 3 of its chain: 165.25 deg is beyond 165 deg");
  EXPECT_EQ(
      text({.kind = Kind::kOutsideLimits, .at = 0.5, .axis = 2, .angle_rad = 165 * kDeg, .limit_rad = 165 * kDeg}),
      "outside_limits, axis 2 at 50 % of the path: it would pass 165 deg between two set-points");
}

}  // namespace
}  // namespace armature::cosim
