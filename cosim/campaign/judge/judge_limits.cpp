#include "cosim/campaign/judge/judge_limits.hpp"

#include <algorithm>
#include <cmath>

#include "controller/base/timebase.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

constexpr double kFollowingShare = 1.5;       // of the following-error limit: the lag of the drive comes on top of it
constexpr double kSpeedShare = 1.5;           // of the speed limit: corrections come on top of the planned speed
constexpr double kRunOutDeg = 1;              // beside half of the way to brake: an arm sinks until its brake engages
constexpr std::int64_t kTolerance = 3;        // counts
constexpr double kElasticToleranceDeg = 0.3;  // a drive without integral stands beside its reference under load
constexpr double kWithstoodShare = 0.5;       // of the torque of brake or drive: the other half is for the load
constexpr double kBrakeS = 0.05;              // besides the time from full speed at full acceleration

AxisLimits axis_limits(const AxisSpec& axis, bool elastic) {
  AxisLimits limits;
  limits.deg_per_count = 360 / (axis.gear_ratio * axis.encoder_lines * kCountsPerLine);
  const double counts_per_deg = 1 / std::fabs(limits.deg_per_count);
  const double brake_deg = axis.max_speed_deg_s * axis.max_speed_deg_s / (2 * axis.max_accel_deg_s2);
  limits.min_deg = axis.limit_switch_deg ? std::min(axis.min_deg, (*axis.limit_switch_deg)[0]) : axis.min_deg;
  limits.max_deg = axis.limit_switch_deg ? std::max(axis.max_deg, (*axis.limit_switch_deg)[1]) : axis.max_deg;
  limits.min_deg -= brake_deg + axis.following_error_deg;
  limits.max_deg += brake_deg + axis.following_error_deg;
  limits.max_counts_per_tick = kSpeedShare * axis.max_speed_deg_s * counts_per_deg * to_seconds(armature::kTickCycles);
  limits.off_path_counts = std::llround(kFollowingShare * axis.following_error_deg * counts_per_deg);
  limits.run_out_counts = std::llround((brake_deg / 2 + kRunOutDeg) * counts_per_deg);
  limits.tolerance_counts = elastic ? std::llround(kElasticToleranceDeg * counts_per_deg) : kTolerance;
  if (elastic && axis.dynamics) {
    const double motor_nm = std::min(axis.dynamics->brake_nm, axis.drive.max_torque_nm);
    limits.withstood_nm = kWithstoodShare * motor_nm * std::fabs(axis.gear_ratio);
  }
  return limits;
}

}  // namespace

JudgeLimits judge_limits(const RobotSpec& robot) {
  JudgeLimits limits;
  limits.axis_count = robot.axis_count;
  double brake_s = 0;
  for (std::size_t i = 0; i < robot.axis_count; ++i) {
    const AxisSpec& axis = robot.axes[i];
    limits.axes[i] = axis_limits(axis, robot.plant == kDynamicPlant);
    brake_s = std::max(brake_s, 2 * axis.max_speed_deg_s / axis.max_accel_deg_s2);
  }
  limits.brake_time = to_cycles(brake_s + kBrakeS);
  return limits;
}

}  // namespace armature::cosim
