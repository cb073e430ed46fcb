#include "cosim/kernel/script/fault_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "controller/base/angle_units.hpp"
#include "controller/base/timebase.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

// A set-point that moves with its greatest speed has rounding errors.
constexpr double kRounding = 1e-6;

}  // namespace

FaultConditions::FaultConditions(const Scenario& scenario) {
  for (std::size_t i = 0; i < kAxes; ++i) {
    const AxisSpec& axis = scenario.robot.axes[i];
    counts_per_deg_[i] = axis.gear_ratio * static_cast<double>(axis.encoder_lines) * kCountsPerLine / 360.0;
  }
  std::ranges::copy_if(scenario.faults, std::back_inserter(waiting_),
                       [](const FaultSpec& fault) { return fault.when != FaultWhen::kTime; });
}

std::vector<FaultSpec> FaultConditions::due(const TraceRow& row) {
  std::vector<FaultSpec> due;
  if (waiting_.empty()) return due;
  const auto begins = [&](const FaultSpec& fault) {
    return to_cycles(fault.at_s) <= Cycles{row.cycle} && holds(fault, row);
  };
  std::ranges::copy_if(waiting_, std::back_inserter(due), begins);
  std::erase_if(waiting_, begins);
  moves_begun_.clear();
  motor_counts_ = row.motor_counts;
  reference_ = row.telemetry.reference;
  has_before_ = true;
  return due;
}

bool FaultConditions::holds(const FaultSpec& fault, const TraceRow& row) const {
  const auto axis = static_cast<std::size_t>(fault.when_axis - 1);
  if (fault.when == FaultWhen::kMoveBegins) {
    return std::ranges::find(moves_begun_, static_cast<std::uint32_t>(fault.when_move)) != moves_begun_.end();
  }
  if (!has_before_) return false;
  if (fault.when == FaultWhen::kSpeed) {
    const double step_deg = (row.telemetry.reference[axis] - reference_[axis]).value() * kDegPerRad;
    return std::fabs(step_deg) >= fault.when_deg_s * kTickSeconds * (1.0 - kRounding);
  }
  const double place = fault.when_deg * counts_per_deg_[axis];
  const bool was_below = static_cast<double>(motor_counts_[axis]) < place;
  return was_below != (static_cast<double>(row.motor_counts[axis]) < place);
}

}  // namespace armature::cosim
