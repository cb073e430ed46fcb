#include "controller/motion/axis_control.hpp"

#include <cmath>
#include <limits>

namespace armature {
namespace {

// Rounding shifts single pulses between ticks, so a limit between two counts needs the larger one.
Pulses largest_count(const AxisUnits& units) {
  return Pulses{static_cast<std::int64_t>(-std::floor(-units.max_pulses_per_tick()))};
}

}  // namespace

AxisControl::AxisControl(const AxisModel& model, bool feedback) noexcept
    : units_{model},
      following_error_limit_rad_{model.following_error_limit_rad},
      following_error_limit_{std::fabs(units_.to_exact_pulses(Radians{model.following_error_limit_rad}))},
      max_deviation_{model.following_error_at_rest_rad > 0.0
                         ? std::fabs(units_.to_exact_pulses(Radians{model.following_error_at_rest_rad}))
                         : std::numeric_limits<double>::infinity()},
      checks_deviation_{model.following_error_at_rest_rad > 0.0},
      feedback_on_{feedback},
      quantizer_{largest_count(units_)},
      feedback_{model, units_, feedback ? 1 : kJudgedTicks} {}

void AxisControl::restart(Pulses emitted, Counts measured) noexcept {
  reference_ = units_.to_radians(measured);
  reference_pulses_ = units_.to_pulses(reference_);
  correction_ = Pulses{0};
  direction_ = 0;
  quantizer_.restart(emitted, reference_pulses_);
  feedback_.restart(emitted, measured);
}

void AxisControl::not_emitted(Pulses count) noexcept {
  quantizer_.not_emitted(count);
  feedback_.not_emitted(count);
}

void AxisControl::set_emitted(Pulses emitted, Pulses active) noexcept {
  quantizer_.not_emitted(quantizer_.committed() - emitted - active);
  feedback_.not_emitted(feedback_.sent() - emitted);
}

}  // namespace armature
