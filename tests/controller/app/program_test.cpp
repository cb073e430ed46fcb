// Long programs of short lines through the whole controller: windows that continue each other, and what is reported.
#include <gmock/gmock.h>

#include <numbers>

#include "tests/controller/support/cartesian_moves.hpp"

namespace armature {
namespace {

using test::kGentle;
using test::kThere;

class Program : public test::CartesianMovesTest {
 protected:
  static constexpr double kBlend_mm = 0.02, kStep_mm = 0.3;

  Program() {
    rig.on_each_trigger = [this] {
      if (rig.logic.triggers() >= kThere && fed_ < supplied(rig.logic.triggers())) feed();
    };
  }

  // Lines on a circle of 30 mm radius, in the base frame.
  [[nodiscard]] CartesianMove line(std::size_t index) const {
    const double angle = kStep_mm / 30.0 * static_cast<double>(index + 1);
    const Eigen::Vector3d offset{0.0, 30.0 * std::sin(angle), 30.0 * (1.0 - std::cos(angle))};
    const bool last = index + 1 == lines_;
    CartesianMove move{.target = {.position_mm = posture().position_mm + offset},
                       .limits = kGentle,
                       .profile = profile_of(index),
                       .blend_mm = last ? 0.0 : kBlend_mm,
                       .tag = static_cast<std::uint32_t>(index + 1)};
    move.limits.jerk_mm_s3 = 2e6;  // a corner needs 0.7e6 at this speed
    return move;
  }

  void feed() {
    while (fed_ < supplied(rig.logic.triggers()) && rig.submit_program(line(fed_))) ++fed_;
  }

  // Ticks from the first line on in which the arm stood before its last move ended.
  [[nodiscard]] std::int64_t ticks_of_rest() const {
    std::int64_t first = -1, last = -1, moving = 0;
    for (const Telemetry& row : rig.rows) {
      if (row.tick.value() < kThere || row.state != MotionState::kMoving) continue;
      if (first < 0) first = row.tick.value();
      last = row.tick.value();
      ++moving;
    }
    return last - first + 1 - moving;
  }

  std::size_t lines_ = 800, fed_ = 0;
  std::function<ProfileKind(std::size_t)> profile_of = [](std::size_t) { return ProfileKind::kTrapezoid; };
  std::function<std::size_t(std::int64_t)> supplied = [this](std::int64_t) { return lines_; };
};

class ProgramOf : public Program, public testing::WithParamInterface<ProfileKind> {};
INSTANTIATE_TEST_SUITE_P(Profiles, ProgramOf, testing::Values(ProfileKind::kTrapezoid, ProfileKind::kSCurve),
                         [](const auto& test) { return test.param == ProfileKind::kSCurve ? "SCurve" : "Trapezoid"; });

TEST_P(ProgramOf, RunsWithoutAStopAtItsSpeedAndEveryMoveIsReported) {
  profile_of = [](std::size_t) { return GetParam(); };
  rig.run(kThere + 52'000);
  EXPECT_TRUE(rig.refusals.empty());
  ASSERT_EQ(rig.moves.size(), lines_ + 1);
  ASSERT_EQ(rig.finished.size(), lines_ + 1);
  for (std::size_t i = 1; i <= lines_; ++i) {
    ASSERT_EQ(rig.moves[i].tag.number(), i);
    ASSERT_EQ(rig.finished[i].tag.number(), i);
    ASSERT_EQ(rig.finished[i].how, MoveFinished::How::kReachedEnd);
    ASSERT_EQ(rig.moves[i].continues, i > 1) << i;
    // Its own line, wherever the window begins.
    ASSERT_LT((rig.moves[i].path.end_mm - line(i - 1).target.position_mm).norm(), 1e-9);
  }
  EXPECT_EQ(ticks_of_rest(), 0);
  EXPECT_LT(path_error_mm(), kBlend_mm);
  const double length_mm = kStep_mm * static_cast<double>(lines_);
  const double ideal_s = length_mm / kGentle.speed_mm_s + kGentle.speed_mm_s / kGentle.accel_mm_s2;
  const Ticks taken = rig.finished.back().tick - rig.moves[1].start_tick;
  // The planning of S-curves takes longer, so the arm has to wait for the first windows at a lower speed.
  EXPECT_LT(seconds(taken), (GetParam() == ProfileKind::kSCurve ? 1.03 : 1.01) * ideal_s);
  rig.expect_pulses_conserved();
}

// The index of each line, from 1, that begins at a stop.
std::vector<std::size_t> stops_before(const std::vector<MoveStarted>& moves) {
  std::vector<std::size_t> lines;
  for (std::size_t i = 1; i < moves.size(); ++i) {
    if (!moves[i].continues) lines.push_back(i);
  }
  return lines;
}

TEST_F(Program, TrapezoidsContinueSCurvesWithoutAStop) {
  lines_ = 600;
  profile_of = [](std::size_t line) { return line < 300 ? ProfileKind::kSCurve : ProfileKind::kTrapezoid; };
  rig.run(kThere + 42'000);
  EXPECT_TRUE(rig.refusals.empty());
  EXPECT_EQ(rig.moves_finished(), 601);
  EXPECT_THAT(stops_before(rig.moves), testing::ElementsAre(1));
  EXPECT_LT(path_error_mm(), kBlend_mm);
}

TEST_F(Program, StopsWhereTrapezoidsBecomeSCurves) {
  lines_ = 600;
  profile_of = [](std::size_t line) { return line < 300 ? ProfileKind::kTrapezoid : ProfileKind::kSCurve; };
  rig.run(kThere + 46'000);
  EXPECT_TRUE(rig.refusals.empty());
  EXPECT_EQ(rig.moves_finished(), 601);
  EXPECT_THAT(stops_before(rig.moves), testing::ElementsAre(1, 301));
  EXPECT_LT(path_error_mm(), kBlend_mm);
}

TEST_P(ProgramOf, ALateSupplyStopsOnThePathAndGoesOn) {
  profile_of = [](std::size_t) { return GetParam(); };
  supplied = [this](std::int64_t trigger) {
    return std::min(lines_, trigger < kThere + 16'000 ? std::size_t{150} : std::size_t{800});
  };
  lines_ = 400;
  rig.run(kThere + 40'000);
  EXPECT_TRUE(rig.refusals.empty());
  EXPECT_EQ(rig.moves_finished(), 401);
  EXPECT_GT(ticks_of_rest(), 0);
  EXPECT_LT(path_error_mm(), kBlend_mm);
  rig.expect_pulses_conserved();
}

TEST_P(ProgramOf, AHoldAndAnOverrideKeepThePath) {
  profile_of = [](std::size_t) { return GetParam(); };
  lines_ = 400;
  rig.submit_at(kThere + 3'000, Hold{});
  rig.submit_at(kThere + 9'000, Resume{});
  rig.submit_at(kThere + 12'000, SetOverride{.share = 0.4});
  rig.submit_at(kThere + 25'000, SetOverride{.share = 1.0});
  rig.run(kThere + 60'000);
  EXPECT_TRUE(rig.refusals.empty());
  EXPECT_EQ(rig.moves_finished(), 401);
  EXPECT_LT(path_error_mm(), kBlend_mm);
  rig.expect_pulses_conserved();
}

// A stop at any time: each line that was given is executed, cut short or refused, once; afterwards the arm obeys.
TEST_F(Program, AStopDropsTheRestOfTheProgramOnce) {
  bool stopped = false;
  supplied = [this, &stopped](std::int64_t) { return stopped ? fed_ : lines_; };
  rig.at(kThere + 6'123, [&] {
    stopped = true;
    rig.submit(Stop{});
  });
  rig.submit_at(kThere + 20'000, shift(5, 0, 0));
  rig.run(kThere + 40'000);
  std::vector<int> ends(fed_ + 1, 0);
  for (const MoveFinished& move : rig.finished) {
    if (move.tag.number() > 0) ++ends.at(move.tag.number());
  }
  for (const MoveRefused& move : rig.refusals) {
    EXPECT_EQ(move.reason, Refusal::kNotReady);
    ++ends.at(move.tag.number());
  }
  for (std::size_t i = 1; i <= fed_; ++i) EXPECT_EQ(ends[i], 1) << i;
  EXPECT_GT(rig.refusals.size(), 100u);
  EXPECT_EQ(rig.moves.back().tag.number(), 0u);  // the last one is executed
  EXPECT_EQ(rig.finished.back().how, MoveFinished::How::kReachedEnd);
  rig.expect_pulses_conserved();
}

TEST_F(Program, ALineOutOfReachIsRefusedAndTheRestBeforeItExecuted) {
  lines_ = 300;
  bool refused = false;
  rig.on_each_trigger = [&] {
    while (rig.logic.triggers() >= kThere && fed_ < lines_) {
      CartesianMove move = line(fed_);
      if (fed_ == 200) move.target.position_mm = {3'000.0, 0.0, 0.0};
      if (!rig.submit_program(move)) break;
      ++fed_;
    }
    refused = refused || !rig.refusals.empty();
  };
  rig.run(kThere + 60'000);
  const auto blamed = std::ranges::find(rig.refusals, Refusal::kUnreachable, &MoveRefused::reason);
  ASSERT_NE(blamed, rig.refusals.end());
  EXPECT_EQ(blamed->tag.number(), 201u);
  EXPECT_EQ(rig.finished.size() + rig.refusals.size(), lines_ + 1);
  rig.expect_pulses_conserved();
}

}  // namespace
}  // namespace armature
