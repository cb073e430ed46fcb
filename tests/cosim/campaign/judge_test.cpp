// The judge of a campaign bites: each kind of silent error, made by hand.
#include "cosim/campaign/judge/judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "controller/base/timebase.hpp"
#include "cosim/fault/fault_spec.hpp"

namespace armature::cosim {
namespace {

constexpr std::int64_t kMoveTicks = 200, kLongTicks = 3000, kFaultTick = 100;
constexpr std::int64_t kCountsPerTick = 10;

RobotSpec robot() {
  RobotSpec robot;
  for (AxisSpec& axis : robot.axes) {
    axis.max_speed_deg_s = 120;
    axis.max_accel_deg_s2 = 600;
  }
  return robot;
}

// Axis 1 moves by 2000 counts, and rests.
std::int64_t planned_counts(std::int64_t tick) {
  return std::min(tick, kMoveTicks) * kCountsPerTick;
}

Cycles cycle_of(std::int64_t tick) {
  return Cycles{(tick + 1) * armature::kTickCycles.value()};
}

TraceRow row_of(std::int64_t tick, std::int64_t counts) {
  TraceRow row;
  row.tick = tick;
  row.cycle = cycle_of(tick).value();
  row.motor_counts[0] = counts;
  row.pin_pulses[0] = counts;
  row.telemetry.encoder[0] = Counts{counts};
  return row;
}

TruePath planned_path() {
  TruePathRecorder recorder;
  recorder.on_signal(ServoEnables{.levels = 0x3F}, {});
  const IntegerDigest digest;
  for (std::int64_t tick = 0; tick < 2 * kMoveTicks; ++tick) {
    recorder.on_row(row_of(tick, planned_counts(tick)), digest);
  }
  return recorder.path();
}

// A run of which a test changes what it needs.
class JudgedRun {
 public:
  explicit JudgedRun(const RobotSpec& spec = robot()) : limits_{judge_limits(spec)} { power(0x3F); }

  // Up to the tick, each with `change(row, tick)`.
  template <class Change>
  void run_to(std::int64_t end, Change change) {
    const IntegerDigest digest;
    for (; tick_ < end && !judge_.may_end(); ++tick_) {
      TraceRow row = row_of(tick_, planned_counts(tick_));
      change(row, tick_);
      judge_.on_row(row, digest);
    }
  }
  void run_to(std::int64_t end) {
    run_to(end, [](TraceRow&, std::int64_t) {});
  }
  void begin(const FaultKind& kind) { judge_.on_action(FaultSpec{.at_s = 0, .kind = kind}, place()); }
  void power(std::uint8_t levels) { judge_.on_signal(ServoEnables{.levels = levels}, place()); }
  void report(FaultCause cause, std::uint8_t axis) { judge_.on_event(Faulted{.cause = cause, .axis = axis}, place()); }
  [[nodiscard]] Verdict verdict(const std::optional<std::string>& failure = {}) const {
    return judge_.verdict(failure);
  }

 private:
  [[nodiscard]] RunPlace place() const { return {.tick = tick_, .at = cycle_of(tick_)}; }

  const JudgeLimits limits_;
  const TruePath path_ = planned_path();
  CampaignJudge judge_{limits_, path_, cycle_of(kFaultTick)};
  std::int64_t tick_ = 0;
};

const FaultKind kAnywhere = InterruptLost{.duration_s = 1e-3};
const FaultKind kAtAxisOne = AxisBlocked{.axis = 1, .duration_s = 1e-3};

TEST(CampaignJudge, TakesARunWithoutFaultForFinished) {
  JudgedRun run;
  run.run_to(kLongTicks);
  EXPECT_EQ(run.verdict().outcome, Outcome::kFinished);
}

TEST(CampaignJudge, TakesAFaultWithoutEffectForMasked) {
  JudgedRun run;
  run.run_to(kFaultTick);
  run.begin(kAnywhere);
  run.run_to(kLongTicks);
  EXPECT_EQ(run.verdict().outcome, Outcome::kMasked);
}

TEST(CampaignJudge, TakesADelayForFinished) {
  JudgedRun run;
  run.run_to(kFaultTick);
  run.begin(kAnywhere);
  run.run_to(kLongTicks, [](TraceRow& row, std::int64_t tick) { row.motor_counts[0] = planned_counts(tick - 20); });
  EXPECT_EQ(run.verdict().outcome, Outcome::kFinished);
}

TEST(CampaignJudge, TakesAReportWithoutPowerForStopped) {
  JudgedRun run;
  run.run_to(kFaultTick);
  run.begin(kAtAxisOne);
  run.run_to(kFaultTick + 7);
  run.report(FaultCause::kFollowingError, 1);
  run.power(0);
  run.run_to(kLongTicks, [](TraceRow& row, std::int64_t) { row = row_of(row.tick, planned_counts(kFaultTick + 7)); });
  const Verdict verdict = run.verdict();
  EXPECT_EQ(verdict.outcome, Outcome::kStopped);
  EXPECT_EQ(verdict.reason, "following_error of axis 1");
  EXPECT_EQ(verdict.latency_ticks, 7);
}

TEST(CampaignJudge, FindsAWrongPosition) {
  for (const std::int64_t off : {3, 4}) {
    JudgedRun run;
    run.run_to(kFaultTick);
    run.begin(kAtAxisOne);
    run.run_to(kLongTicks, [&](TraceRow& row, std::int64_t) { row.motor_counts[0] += off; });
    EXPECT_EQ(run.verdict().outcome, off == 3 ? Outcome::kFinished : Outcome::kWrongPosition);
  }
}

TEST(CampaignJudge, FindsLostCounts) {
  JudgedRun run;
  run.run_to(kFaultTick);
  run.begin(kAtAxisOne);
  run.run_to(kLongTicks, [](TraceRow& row, std::int64_t) { row.telemetry.encoder[0] += Counts{4}; });
  EXPECT_EQ(run.verdict().outcome, Outcome::kWrongPosition);
  EXPECT_EQ(run.verdict().reason, "axis 1: 4 counts are lost");
}

TEST(CampaignJudge, FindsPulsesAfterTheStop) {
  JudgedRun run;
  run.run_to(kFaultTick);
  run.begin(Estop{.duration_s = 1e-3});
  run.power(0);
  run.run_to(kLongTicks, [](TraceRow& row, std::int64_t) { row.motor_counts[0] = planned_counts(kFaultTick); });
  EXPECT_EQ(run.verdict().outcome, Outcome::kMotionAfterStop);
  EXPECT_EQ(run.verdict().reason, "axis 1 gets pulses after the stop");
}

TEST(CampaignJudge, FindsMotionAfterTheStop) {
  JudgedRun run;
  run.run_to(kFaultTick);
  run.begin(Estop{.duration_s = 1e-3});
  run.power(0);
  run.run_to(kLongTicks, [](TraceRow& row, std::int64_t tick) {
    row.motor_counts[0] = planned_counts(kFaultTick) + (tick - kFaultTick) * 12;
    row.pin_pulses[0] = planned_counts(kFaultTick);
  });
  EXPECT_EQ(run.verdict().outcome, Outcome::kMotionAfterStop);
  EXPECT_EQ(run.verdict().reason, "axis 1 moves after the stop");
}

TEST(CampaignJudge, FindsPowerThatComesBack) {
  JudgedRun run;
  run.run_to(kFaultTick);
  run.begin(Estop{.duration_s = 1e-3});
  run.power(0);
  run.run_to(kFaultTick + 20, [](TraceRow& row, std::int64_t) { row = row_of(row.tick, planned_counts(kFaultTick)); });
  run.power(0x3F);
  run.run_to(kLongTicks);
  EXPECT_EQ(run.verdict().outcome, Outcome::kMotionAfterStop);
}

TEST(CampaignJudge, FindsAPositionBehindTheRange) {
  // 180 deg, and beyond it the way to brake of 12 deg and the following error of 5 deg.
  constexpr double kCountsPerDeg = 50 * 10'000 / 360.0;
  for (const double deg : {196.9, 197.1}) {
    JudgedRun run;
    run.run_to(kFaultTick / 2);
    run.begin(kAtAxisOne);
    run.report(FaultCause::kFollowingError, 1);
    run.run_to(kFaultTick / 2 + 1,
               [&](TraceRow& row, std::int64_t) { row.motor_counts[0] = std::llround(deg * kCountsPerDeg); });
    run.power(0);
    EXPECT_EQ(run.verdict().outcome == Outcome::kLimitExceeded, deg > 197) << deg;
  }
}

TEST(CampaignJudge, FindsASpeedAboveTheLimit) {
  // One and a half times 120 deg/s are 12.5 counts a tick.
  for (const std::int64_t half_counts : {24, 26}) {
    JudgedRun run;
    run.begin(kAtAxisOne);
    run.run_to(kFaultTick + 20,
               [&](TraceRow& row, std::int64_t tick) { row.motor_counts[0] = tick * half_counts / 2; });
    EXPECT_EQ(run.verdict().outcome == Outcome::kLimitExceeded, half_counts == 26) << half_counts;
  }
}

// A campaign took each of these for a speed above the limit: while the clock of the logic stands there are no rows.
TEST(CampaignJudge, MeasuresTheSpeedAlsoWhereRowsAreMissing) {
  constexpr std::int64_t kMissing = 100;
  for (const std::int64_t half_counts : {24, 26}) {
    JudgedRun run;
    run.begin(ClockStop{.duration_s = 5e-3});
    run.run_to(kFaultTick + 20, [&](TraceRow& row, std::int64_t tick) {
      const std::int64_t late = tick < kFaultTick ? 0 : kMissing;
      row.cycle = cycle_of(tick + late).value();
      row.motor_counts[0] = (tick + late) * half_counts / 2;
    });
    EXPECT_EQ(run.verdict().outcome == Outcome::kLimitExceeded, half_counts == 26) << half_counts;
  }
}

// The same robot with gears and brakes: half of what the brake of a joint holds are 50 N m.
RobotSpec braked_robot() {
  RobotSpec spec = robot();
  spec.plant = kDynamicPlant;
  for (AxisSpec& axis : spec.axes) {
    axis.drive.max_torque_nm = 4;
    axis.dynamics = DynamicsSpec{.brake_nm = 2};
    axis.max_accel_deg_s2 = 6000;
  }
  return spec;
}

constexpr std::int64_t kPushTicks = 100, kPushedCounts = 40;
FaultKind push(double torque_nm) {
  return CollisionTorque{.axis = 2, .torque_nm = torque_nm, .duration_s = 5e-3};
}

// Axis 1 stands at the stop, but a push moves it, faster than its limit. `later`: counts that it moves long after the
// push.
Verdict verdict_of_push(double torque_nm, std::int64_t later) {
  JudgedRun run{braked_robot()};
  run.run_to(kFaultTick);
  run.begin(push(torque_nm));
  run.report(FaultCause::kEncoderSpeed, 1);
  run.power(0);
  run.run_to(kLongTicks, [&](TraceRow& row, std::int64_t tick) {
    row = row_of(row.tick, planned_counts(kFaultTick));
    row.motor_counts[0] += std::min(tick - kFaultTick, kPushTicks) * kPushedCounts;
    row.motor_counts[0] += std::clamp<std::int64_t>((tick - kFaultTick - 500) * kCountsPerTick, 0, later);
  });
  return run.verdict();
}

// No controller holds the arm then, so what it does until it rests is not the controller's fault.
TEST(CampaignJudge, DoesNotJudgeTheMotionOfAnArmThatIsPushedStrongly) {
  EXPECT_EQ(verdict_of_push(51, 0).outcome, Outcome::kStopped);
  EXPECT_EQ(verdict_of_push(-51, 0).outcome, Outcome::kStopped);
  EXPECT_EQ(verdict_of_push(49, 0).reason, "axis 1 is too fast");
}

TEST(CampaignJudge, TakesABlameOfAnyAxisAfterAStrongPush) {
  for (const double torque_nm : {49, 51}) {
    JudgedRun run{braked_robot()};
    run.run_to(kFaultTick);
    run.begin(push(torque_nm));  // of axis 2
    run.report(FaultCause::kEncoderSpeed, 1);
    run.power(0);
    run.run_to(kLongTicks, [](TraceRow& row, std::int64_t) { row = row_of(row.tick, planned_counts(kFaultTick)); });
    EXPECT_EQ(run.verdict().outcome, torque_nm > 50 ? Outcome::kStopped : Outcome::kWrongFault);
  }
}

// From where the push left the axis: half of the way to brake of 1.2 deg, and 1 deg.
TEST(CampaignJudge, FindsMotionAfterAStrongPush) {
  EXPECT_EQ(verdict_of_push(51, 2'200).outcome, Outcome::kStopped);
  EXPECT_EQ(verdict_of_push(51, 2'250).reason, "axis 1 moves after the stop");
}

TEST(CampaignJudge, FindsAStrongPushThatIsNotDetected) {
  JudgedRun run{braked_robot()};
  run.run_to(kFaultTick);
  run.begin(push(51));
  run.run_to(kLongTicks, [&](TraceRow& row, std::int64_t tick) { row.motor_counts[0] = tick * kPushedCounts; });
  EXPECT_EQ(run.verdict().outcome, Outcome::kTooLate);
}

TEST(CampaignJudge, FindsAnArmThatStandsBeforeItsEnd) {
  JudgedRun run;
  run.run_to(kFaultTick);
  run.begin(kAnywhere);
  run.run_to(kLongTicks, [](TraceRow& row, std::int64_t) { row = row_of(row.tick, planned_counts(kFaultTick)); });
  EXPECT_EQ(run.verdict().outcome, Outcome::kHang);
}

TEST(CampaignJudge, FindsPowerThatStaysAfterAnEmergencyStop) {
  JudgedRun run;
  run.run_to(kFaultTick);
  run.begin(Estop{.duration_s = 1e-3});
  run.run_to(kFaultTick + 15);
  run.power(0);
  run.run_to(kLongTicks);
  EXPECT_EQ(run.verdict().outcome, Outcome::kServosOn);
}

TEST(CampaignJudge, FindsPowerThatStaysAfterAReport) {
  JudgedRun run;
  run.run_to(kFaultTick);
  run.begin(kAtAxisOne);
  run.report(FaultCause::kDriveAlarm, 1);
  run.run_to(kLongTicks + 9000, [](TraceRow& row, std::int64_t tick) { row.motor_counts[0] = tick % 2; });
  EXPECT_EQ(run.verdict().outcome, Outcome::kServosOn);
}

TEST(CampaignJudge, FindsAnArmOffItsPath) {
  // One and a half times the following error of 5 deg are 10417 counts.
  for (const std::int64_t off : {10'300, 10'600}) {
    JudgedRun run;
    run.run_to(kFaultTick);
    run.begin(kAtAxisOne);
    run.run_to(kLongTicks, [&](TraceRow& row, std::int64_t tick) {
      if (tick >= 300 && tick < 2300)
        row.motor_counts[0] = planned_counts(tick) + std::min<std::int64_t>((tick - 300) * 8, off);
      if (tick >= 2300) row.motor_counts[0] = planned_counts(tick) + std::max<std::int64_t>(off - (tick - 2300) * 8, 0);
    });
    EXPECT_EQ(run.verdict().outcome == Outcome::kTooLate, off == 10'600) << off << run.verdict().reason;
  }
}

TEST(CampaignJudge, FindsTheWrongAxisBlamed) {
  for (const int axis : {1, 2}) {
    JudgedRun run;
    run.run_to(kFaultTick);
    run.begin(kAtAxisOne);
    run.report(FaultCause::kFollowingError, static_cast<std::uint8_t>(axis));
    run.power(0);
    run.run_to(kLongTicks, [](TraceRow& row, std::int64_t) { row = row_of(row.tick, planned_counts(kFaultTick)); });
    EXPECT_EQ(run.verdict().outcome, axis == 1 ? Outcome::kStopped : Outcome::kWrongFault);
  }
}

TEST(CampaignJudge, FindsAStopBeforeAnyFault) {
  JudgedRun run;
  run.run_to(kFaultTick);
  run.report(FaultCause::kEncoder, 1);
  run.power(0);
  run.run_to(kFaultTick + 10, [](TraceRow& row, std::int64_t) { row = row_of(row.tick, planned_counts(kFaultTick)); });
  run.begin(kAtAxisOne);
  run.run_to(kLongTicks, [](TraceRow& row, std::int64_t) { row = row_of(row.tick, planned_counts(kFaultTick)); });
  EXPECT_EQ(run.verdict().outcome, Outcome::kWrongFault);
}

TEST(CampaignJudge, ReportsARunThatWasBrokenOff) {
  JudgedRun run;
  run.run_to(kFaultTick);
  EXPECT_EQ(run.verdict("an invariant does not hold").outcome, Outcome::kFailed);
}

}  // namespace
}  // namespace armature::cosim
