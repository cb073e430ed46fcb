#include "controller/activity/owner_state.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace armature {
namespace {

struct OwnerStateTest : testing::Test {
  void start_axis(std::uint8_t axis) { state.on_event(HomingStarted{.axis = axis}); }
  void end_axis(std::uint8_t axis, HomingEnd how) { state.on_event(HomingEnded{.axis = axis, .how = how}); }
  OwnerState state;
};

TEST_F(OwnerStateTest, MovesUntilEachStartedMoveIsFinished) {
  EXPECT_FALSE(state.moves());
  state.on_event(MoveStarted{.tag = 1});
  state.on_event(MoveStarted{.tag = 2});
  state.on_event(MoveRefused{.tag = 3});
  state.on_event(MoveFinished{.tag = 1});
  EXPECT_TRUE(state.moves());
  state.on_event(MoveFinished{.tag = 2});
  EXPECT_FALSE(state.moves());
}

TEST_F(OwnerStateTest, AJogIsNoMoveAndEndsWithItsEndOrAFault) {
  state.on_event(JogStarted{});
  EXPECT_TRUE(state.jogs());
  EXPECT_FALSE(state.moves());
  state.on_event(JogEnded{});
  EXPECT_FALSE(state.jogs());
  state.on_event(JogStarted{});
  state.on_event(Faulted{.cause = FaultCause::kEstop});
  EXPECT_FALSE(state.jogs());
}

TEST_F(OwnerStateTest, HomingMovesUntilAllAxesAreHomedOrOneFails) {
  start_axis(1);
  start_axis(6);
  end_axis(6, HomingEnd::kHomed);
  EXPECT_TRUE(state.moves());
  end_axis(1, HomingEnd::kHomed);
  EXPECT_FALSE(state.moves());
  start_axis(2);
  start_axis(3);
  end_axis(3, HomingEnd::kNoSwitch);
  EXPECT_FALSE(state.moves());
}

TEST_F(OwnerStateTest, KeepsTheLatestFaultUntilItIsCleared) {
  EXPECT_FALSE(state.fault());
  state.on_event(Faulted{.cause = FaultCause::kDrivesOff});
  state.on_event(Faulted{.cause = FaultCause::kDriveAlarm, .axis = 4});
  ASSERT_TRUE(state.fault());
  EXPECT_EQ(state.fault()->cause, FaultCause::kDriveAlarm);
  EXPECT_EQ(state.fault()->axis, 4);
  state.on_event(FaultCleared{});
  EXPECT_FALSE(state.fault());
}

}  // namespace
}  // namespace armature
