// The words that files and messages use for the controller's enumerations.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "controller/motion/telemetry.hpp"

namespace armature::cosim {

inline constexpr std::array<std::string_view, 4> kStateNames{"idle", "moving", "stopping", "fault"};

// How a run ended: the end state is kFault with this cause, or (kNone) it is not.
inline constexpr std::array<std::string_view, 8> kOutcomeNames{
    "completed",         "fault:emergency_stop", "fault:watchdog",     "fault:following_error",
    "fault:drive_alarm", "fault:encoder",        "fault:limit_switch", "fault:hardware_id"};

inline constexpr std::array<std::string_view, 3> kShapeNames{"none", "triangle", "trapezoid"};

inline constexpr std::array<std::string_view, 4> kRefusalNames{"outside_limits", "not_ready", "queue_full",
                                                               "invalid_target"};

constexpr std::string_view state_name(MotionState state) {
  return kStateNames[static_cast<std::size_t>(state)];
}
constexpr std::string_view outcome_name(FaultCause cause) {
  return kOutcomeNames[static_cast<std::size_t>(cause)];
}
constexpr std::string_view shape_name(ProfileShape shape) {
  return kShapeNames[static_cast<std::size_t>(shape)];
}
constexpr std::string_view refusal_name(Refusal reason) {
  return kRefusalNames[static_cast<std::size_t>(reason)];
}
// The cause alone, `watchdog`.
constexpr std::string_view fault_name(FaultCause cause) {
  const std::string_view outcome = outcome_name(cause);
  return cause == FaultCause::kNone ? std::string_view{"none"} : outcome.substr(outcome.find(':') + 1);
}

static_assert(outcome_name(FaultCause::kHardwareId) == "fault:hardware_id");
static_assert(state_name(MotionState::kFault) == "fault");
static_assert(shape_name(ProfileShape::kTrapezoid) == "trapezoid");
static_assert(refusal_name(Refusal::kInvalidTarget) == "invalid_target");

}  // namespace armature::cosim
