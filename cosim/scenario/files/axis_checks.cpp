#include "cosim/scenario/files/axis_checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "controller/base/angle_units.hpp"
#include "controller/base/timebase.hpp"
#include "controller/regs/encoder_regs.hpp"
#include "cosim/robot/motor_step.hpp"
#include "cosim/scenario/toml/value_rule.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

constexpr double kMaxPulseRateHz = 4e6;  // the logic emits at most 200 pulses in 50 us
// With fewer cycles the debounce filter of the logic would treat the edges of the encoder as glitches.
constexpr std::int64_t kMinCyclesPerCount = regs::encoder::kDebounceTimeReset + 1;
constexpr double kRounding = 1e-12;  // relative; lets a limit be met exactly
constexpr double kDegPerSecToRpm = 60.0 / 360.0;
constexpr double kLeastGear = 0.01;

// How an axis fails a check. `excess` compares the axes that fail the same check. The largest is the worst.
struct Failure {
  double excess = 0;
  std::string message;  // for the first of the check's keys
};

struct IndexedFailure {
  std::size_t axis = 0;
  Failure failure;
};

// The keys that take part. The problem is reported at the first one.
struct Check {
  std::vector<std::string_view> keys;
  std::optional<Failure> (*failure)(const AxisSpec& axis);
};

std::string rounded(double value) {
  return number_text(std::round(value * 1e3) / 1e3);
}

double gear(const AxisSpec& axis) {
  return std::fabs(axis.gear_ratio);
}

// Motor turns a second at full speed.
double motor_turns(const AxisSpec& axis) {
  return axis.max_speed_deg_s * gear(axis) / 360.0;
}

std::optional<Failure> check_gear(const AxisSpec& axis) {
  if (gear(axis) >= kLeastGear) return std::nullopt;
  return Failure{-gear(axis), "expected a magnitude of at least " + number_text(kLeastGear) + ", found " +
                                  number_text(axis.gear_ratio)};
}

std::optional<Failure> check_limits(const AxisSpec& axis) {
  if (axis.min_deg < axis.max_deg) return std::nullopt;
  return Failure{axis.min_deg - axis.max_deg,
                 "expected less than max_deg = " + number_text(axis.max_deg) + ", found " + number_text(axis.min_deg)};
}

std::optional<Failure> check_home_switch(const AxisSpec& axis) {
  if (!axis.home_switch_deg || axis.home_switch_deg->front() < axis.home_switch_deg->back()) return std::nullopt;
  return Failure{0, "expected an end above the start " + number_text(axis.home_switch_deg->front()) + ", found " +
                        number_text(axis.home_switch_deg->back())};
}

std::optional<Failure> check_limit_switches(const AxisSpec& axis) {
  if (!axis.limit_switch_deg) return std::nullopt;
  const auto& [negative, positive] = *axis.limit_switch_deg;
  if (negative <= axis.min_deg && positive >= axis.max_deg) return std::nullopt;
  return Failure{std::max(negative - axis.min_deg, axis.max_deg - positive),
                 "expected at most min_deg = " + number_text(axis.min_deg) + " and at least max_deg = " +
                     number_text(axis.max_deg) + ", found " + number_text(negative) + " and " + number_text(positive)};
}

std::optional<Failure> check_home_position(const AxisSpec& axis) {
  if (!axis.homing) return std::nullopt;
  const double deg = axis.homing->position_deg;
  if (deg >= axis.min_deg && deg <= axis.max_deg) return std::nullopt;
  return Failure{std::max(axis.min_deg - deg, deg - axis.max_deg),
                 "expected an angle from min_deg = " + number_text(axis.min_deg) +
                     " to max_deg = " + number_text(axis.max_deg) + ", found " + number_text(deg)};
}

std::optional<Failure> check_motor_speed(const AxisSpec& axis) {
  const double rpm = axis.max_speed_deg_s * gear(axis) * kDegPerSecToRpm;
  if (rpm <= axis.drive.max_speed_rpm * (1 + kRounding)) return std::nullopt;
  return Failure{rpm / axis.drive.max_speed_rpm,
                 "needs " + rounded(rpm) +
                     " rpm of the motor, more than drive.max_speed_rpm = " + number_text(axis.drive.max_speed_rpm)};
}

std::optional<Failure> check_pulse_rate(const AxisSpec& axis) {
  const double rate = motor_turns(axis) * axis.pulses_per_rev;
  if (rate <= kMaxPulseRateHz * (1 + kRounding)) return std::nullopt;
  return Failure{rate, "needs " + rounded(rate) + " pulses/s with pulses_per_rev = " +
                           std::to_string(axis.pulses_per_rev) + ", more than 4000000 (200 in 50 us)"};
}

std::optional<Failure> check_count_rate(const AxisSpec& axis) {
  const double rate = motor_turns(axis) * (static_cast<double>(axis.encoder_lines) * kCountsPerLine);
  if (rate * kMinCyclesPerCount <= kClkFreqHz * (1 + kRounding)) return std::nullopt;
  return Failure{rate, "gives " + rounded(rate) + " counts/s with encoder_lines = " +
                           std::to_string(axis.encoder_lines) + ", less than " + std::to_string(kMinCyclesPerCount) +
                           " clock cycles a count, which the debounce of the logic needs"};
}

std::optional<Failure> check_torque(const AxisSpec& axis) {
  const double torque = axis.max_accel_deg_s2 * gear(axis) * kRadPerDeg * axis.drive.inertia_kg_m2;
  if (torque <= axis.drive.max_torque_nm * (1 + kRounding)) return std::nullopt;
  return Failure{torque / axis.drive.max_torque_nm,
                 "needs " + rounded(torque) + " N m to turn drive.inertia_kg_m2, more than drive.max_torque_nm = " +
                     number_text(axis.drive.max_torque_nm)};
}

// A second-order loop follows a ramp with a delay of 2 damping / natural frequency.
std::optional<Failure> check_lag(const AxisSpec& axis) {
  const double lag_deg =
      axis.max_speed_deg_s * 2.0 * axis.drive.damping / (2.0 * std::numbers::pi * axis.drive.natural_hz);
  if (lag_deg < axis.following_error_deg) return std::nullopt;
  return Failure{lag_deg / axis.following_error_deg, "expected more than the drive's own lag of " + rounded(lag_deg) +
                                                         " deg at max_speed_deg_s, found " +
                                                         number_text(axis.following_error_deg)};
}

std::optional<Failure> check_monitor(const std::optional<double>& limit, double of_moves, std::string_view name) {
  if (!limit || *limit > of_moves) return std::nullopt;
  return Failure{of_moves / *limit, "expected more than " + std::string{name} + " = " + number_text(of_moves) +
                                        ", found " + number_text(*limit)};
}

std::optional<Failure> check_encoder_speed(const AxisSpec& axis) {
  return check_monitor(axis.encoder_speed_limit_deg_s, axis.max_speed_deg_s, "max_speed_deg_s");
}

std::optional<Failure> check_encoder_accel(const AxisSpec& axis) {
  return check_monitor(axis.encoder_accel_limit_deg_s2, axis.max_accel_deg_s2, "max_accel_deg_s2");
}

std::optional<Failure> check_stiffness(const AxisSpec& axis) {
  if (!axis.dynamics) return std::nullopt;
  const double most =
      0.1 * axis.dynamics->rotor_inertia_kg_m2 * gear(axis) * gear(axis) / (kMotorStepSeconds * kMotorStepSeconds);
  if (axis.dynamics->stiffness_nm_rad <= most) return std::nullopt;
  return Failure{axis.dynamics->stiffness_nm_rad / most,
                 "expected at most " + rounded(most) + " with this rotor and gear_ratio, for steps of 5 us, found " +
                     number_text(axis.dynamics->stiffness_nm_rad)};
}

std::optional<Failure> check_speed_loop(const AxisSpec& axis) {
  if (!axis.dynamics) return std::nullopt;
  const double bandwidth = 2.0 * axis.drive.damping * 2.0 * std::numbers::pi * axis.drive.natural_hz;
  const double most = kMaxSpeedLoopPerStep * axis.dynamics->rotor_inertia_kg_m2 / (bandwidth * kMotorStepSeconds);
  if (axis.drive.inertia_kg_m2 <= most) return std::nullopt;
  return Failure{axis.drive.inertia_kg_m2 / most,
                 "expected at most " + number_text(most) + " for this rotor, natural_hz and damping, found " +
                     number_text(axis.drive.inertia_kg_m2) + ": the speed loop would be too fast for steps of 5 us"};
}

// At rated torque the heat must not rise.
std::optional<Failure> check_overload(const AxisSpec& axis) {
  if (!axis.dynamics) return std::nullopt;
  const double rated = axis.dynamics->rated_torque_nm, of_200 = axis.dynamics->overload_200_s;
  const double found = axis.dynamics->overload_300_s, most = 0.375 * of_200;
  if (rated == 0 && of_200 == 0 && found == 0) return std::nullopt;
  if (rated > 0 && found > 0 && found <= most * (1 + kRounding)) return std::nullopt;
  return Failure{found - most, "expected above 0 and at most 3/8 of overload_200_s = " + number_text(of_200) +
                                   ", with a rated_torque_nm, found " + number_text(found)};
}

const std::vector<Check>& checks() {
  static const std::vector<Check> kChecks{
      {{"min_deg", "max_deg"}, check_limits},
      {{"home_switch_deg"}, check_home_switch},
      {{"limit_switch_deg", "min_deg", "max_deg"}, check_limit_switches},
      {{"homing.position_deg", "min_deg", "max_deg"}, check_home_position},
      {{"max_speed_deg_s", "drive.max_speed_rpm", "gear_ratio"}, check_motor_speed},
      {{"max_speed_deg_s", "pulses_per_rev", "gear_ratio"}, check_pulse_rate},
      {{"max_speed_deg_s", "encoder_lines", "gear_ratio"}, check_count_rate},
      {{"max_accel_deg_s2", "drive.max_torque_nm", "drive.inertia_kg_m2", "gear_ratio"}, check_torque},
      {{"following_error_deg", "drive.natural_hz", "drive.damping", "max_speed_deg_s"}, check_lag},
      {{"encoder_speed_limit_deg_s", "max_speed_deg_s"}, check_encoder_speed},
      {{"encoder_accel_limit_deg_s2", "max_accel_deg_s2"}, check_encoder_accel},
      {{"dynamics.stiffness_nm_rad", "dynamics.rotor_inertia_kg_m2", "gear_ratio"}, check_stiffness},
      {{"drive.inertia_kg_m2", "dynamics.rotor_inertia_kg_m2", "drive.natural_hz", "drive.damping"}, check_speed_loop},
      {{"dynamics.overload_300_s", "dynamics.overload_200_s", "dynamics.rated_torque_nm"}, check_overload},
  };
  return kChecks;
}

// A key of a table or of a table in it (`drive.damping`); nullptr when it is not written.
const ConfigEntry* find_key(const ConfigValue* table, std::string_view key) {
  if (table == nullptr) return nullptr;
  const std::size_t dot = key.find('.');
  const ConfigEntry* entry = table->find(key.substr(0, dot));
  if (entry == nullptr || dot == std::string_view::npos) return entry;
  return find_key(&entry->value, key.substr(dot + 1));
}

std::string axis_text(std::size_t index) {
  return element_key("axis", index);
}

class Reporter {
 public:
  Reporter(const ConfigValue& root, std::size_t axes, ProblemList& problems)
      : axes_{axes}, tables_{root.find("axis")->value.array()}, problems_{&problems} {
    if (const ConfigEntry* entry = root.find("defaults")) defaults_ = &entry->value;
  }

  void report(const Check& check, std::vector<IndexedFailure> failures) {
    const std::string_view reported_at = check.keys.front();
    if (failures.size() == axes_ && axes_ > 1) {
      // If every axis fails, the cause is the value that they all inherit.
      for (const std::string_view key : check.keys) {
        if (std::ranges::all_of(failures, [&](const IndexedFailure& failure) { return inherits(failure.axis, key); })) {
          return report_default(key, reported_at, failures);
        }
      }
    }
    std::vector<IndexedFailure> shared;
    std::ranges::copy_if(failures, std::back_inserter(shared),
                         [&](const IndexedFailure& failure) { return inherits(failure.axis, reported_at); });
    if (shared.size() > 1) {
      report_default(reported_at, reported_at, shared);
      std::erase_if(failures, [&](const IndexedFailure& failure) { return inherits(failure.axis, reported_at); });
    }
    for (const IndexedFailure& failure : failures) report_axis(reported_at, failure);
  }

 private:
  [[nodiscard]] bool inherits(std::size_t axis, std::string_view key) const {
    return find_key(&(*tables_)[axis], key) == nullptr && find_key(defaults_, key) != nullptr;
  }

  void report_axis(std::string_view key, const IndexedFailure& failure) {
    const ConfigValue& table = (*tables_)[failure.axis];
    const ConfigEntry* entry = find_key(&table, key);
    if (entry == nullptr) entry = find_key(defaults_, key);
    problems_->add(entry == nullptr ? table.origin : entry->value.origin,
                   axis_text(failure.axis) + "." + std::string{key}, failure.failure.message);
  }

  void report_default(std::string_view key, std::string_view reported_at, const std::vector<IndexedFailure>& failures) {
    const IndexedFailure& worst =
        *std::ranges::max_element(failures, {}, [](const IndexedFailure& failure) { return failure.failure.excess; });
    const std::string worst_axis = axis_text(worst.axis);
    std::string message = worst.failure.message;
    const bool same = std::ranges::all_of(
        failures, [&](const IndexedFailure& failure) { return failure.failure.message == message; });
    std::string who = "all axes";
    if (failures.size() < axes_) {
      who.clear();
      for (const IndexedFailure& failure : failures) who += (who.empty() ? "" : ", ") + axis_text(failure.axis);
    }
    if (key != reported_at) message = worst_axis + "." + std::string{reported_at} + ": " + message;
    if (!same) {
      message += " (" + (key == reported_at ? worst_axis + ", " : "") + "the worst of " + who + ")";
    } else if (failures.size() < axes_ || key != reported_at) {
      message += " (" + who + ")";
    }
    problems_->add(find_key(defaults_, key)->value.origin, "defaults." + std::string{key}, message);
  }

  std::size_t axes_;
  const ConfigValue::Array* tables_;
  const ConfigValue* defaults_ = nullptr;
  ProblemList* problems_;
};

}  // namespace

void check_axes(const ConfigValue& root, const std::vector<ReadAxis>& axes, ProblemList& problems) {
  if (axes.empty()) return;
  Reporter reporter{root, axes.size(), problems};
  const auto apply = [&](const Check& check, const std::vector<ReadAxis>& to) {
    std::vector<IndexedFailure> failures;
    for (const ReadAxis& axis : to) {
      if (auto failure = check.failure(axis.spec)) failures.push_back({axis.index, *std::move(failure)});
    }
    if (!failures.empty()) reporter.report(check, std::move(failures));
  };
  apply({{"gear_ratio"}, check_gear}, axes);
  // The others divide by the gear.
  std::vector<ReadAxis> geared;
  std::ranges::copy_if(axes, std::back_inserter(geared), [](const ReadAxis& axis) { return !check_gear(axis.spec); });
  for (const Check& check : checks()) apply(check, geared);
}

}  // namespace armature::cosim
