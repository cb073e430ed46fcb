// The words that files and messages use for the controller's enumerations.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "controller/command/command.hpp"
#include "controller/event/event.hpp"
#include "controller/kinematics/configuration.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/motion/telemetry.hpp"
#include "controller/trajectory/path/segment_request.hpp"

namespace armature::cosim {

inline constexpr std::array<std::string_view, 5> kStateNames{"idle", "moving", "stopping", "fault", "holding"};

// How a run ended: in the state kFault with this cause, or not in kFault (kNone). The controller cannot report the last
// one: the servo enables dropped, and the controller did not notice.
inline constexpr std::array<std::string_view, 11> kOutcomeNames{
    "completed",         "fault:estop",   "fault:watchdog",         "fault:following_error",
    "fault:drive_alarm", "fault:encoder", "fault:limit_switch",     "fault:hardware_id",
    "fault:drives_off",  "fault:clock",   "fault:controller_silent"};
inline constexpr std::string_view kCompleted = kOutcomeNames.front();
inline constexpr std::string_view kControllerSilent = kOutcomeNames.back();
// For a run that the user ended. [expect] does not have this outcome.
inline constexpr std::string_view kInterruptedOutcome = "interrupted";

inline constexpr std::array<std::string_view, 4> kShapeNames{"none", "triangle", "trapezoid", "scurve"};

inline constexpr std::array<std::string_view, 5> kMoveNames{"joint", "line", "arc", "spline", "dwell"};

inline constexpr std::array<std::string_view, 20> kRefusalNames{
    "outside_limits", "not_ready",      "queue_full",  "invalid_target", "no_kinematics",
    "no_jerk_limit",  "unreachable",    "orientation", "singular",       "too_fast",
    "no_circle",      "chain_refused",  "replaced",    "input_timeout",  "configuration",
    "no_spline",      "output_outside", "part_lost",   "belt_too_fast",  "not_referenced"};

inline constexpr std::array<std::string_view, 3> kAtSingularityNames{"refuse", "slow", "bend"};

inline constexpr std::array<std::string_view, 4> kOrientationNames{"steady", "fixed", "tangent", "slerp"};

// The sides of a configuration. The first is that of a request for none.
inline constexpr std::array<std::string_view, 3> kShoulderNames{"nearest", "front", "back"};
inline constexpr std::array<std::string_view, 3> kElbowNames{"nearest", "up", "down"};
inline constexpr std::array<std::string_view, 3> kWristNames{"nearest", "noflip", "flip"};

inline constexpr std::array<std::string_view, 8> kJogEndNames{"duration",      "time_out", "released", "limit",
                                                              "cannot_follow", "stop",     "hold",     "fault"};

inline constexpr std::array<std::string_view, 8> kHomingEndNames{
    "homed", "no_switch", "switch_stuck", "no_index", "index_at_edge", "limit", "stop", "fault"};

inline constexpr std::array<std::string_view, 4> kStreamEndNames{"complete", "late", "stopped", "fault"};

inline constexpr std::array<std::string_view, 6> kPartEndNames{"released",      "window",  "too_fast",
                                                               "cannot_follow", "stopped", "fault"};

// How a program ended. The last two: the run ended before the program, or before its begin.
inline constexpr std::array<std::string_view, 8> kProgramEndNames{"ended",  "alarm", "stopped", "aborted",
                                                                  "paused", "held",  "running", "waiting"};

inline constexpr std::array<std::string_view, 12> kProgramNoteNames{
    "line", "message", "alarm", "stopped", "paused", "held", "resumed", "aborted", "ended", "waits", "waited", "over"};

constexpr std::string_view part_end_name(PartEnd end) {
  return kPartEndNames[static_cast<std::size_t>(end)];
}
constexpr std::string_view program_note_name(ProgramNoted::Kind kind) {
  return kProgramNoteNames[static_cast<std::size_t>(kind)];
}
constexpr std::string_view state_name(MotionState state) {
  return kStateNames[static_cast<std::size_t>(state)];
}
constexpr std::string_view outcome_name(FaultCause cause) {
  return kOutcomeNames[static_cast<std::size_t>(cause)];
}
constexpr std::string_view stream_end_name(StreamEnded::How how) {
  return kStreamEndNames[static_cast<std::size_t>(how)];
}
constexpr std::string_view shape_name(ProfileShape shape) {
  return kShapeNames[static_cast<std::size_t>(shape)];
}
// As the scenario calls its type; an arc about an axis is an `arc`, a `circle` or a `helix`. A circle is an arc that
// ends where it begins.
inline std::string_view move_name(const MoveStarted& move) {
  if (move.kind == MoveKind::kArc && move.path.advance_mm != 0) return "helix";
  if (move.kind == MoveKind::kArc && move.path.start_mm == move.path.end_mm) return "circle";
  return kMoveNames[static_cast<std::size_t>(move.kind)];
}
// The joint or tool that is too fast on a path: `joint 4` for axis 4, or `the tool`, in a rounded corner, for 0.
inline std::string_view mover_name(std::uint8_t axis) {
  static constexpr std::array<std::string_view, kAxes + 1> kNames{"the tool", "joint 1", "joint 2", "joint 3",
                                                                  "joint 4",  "joint 5", "joint 6"};
  return kNames[axis];
}
constexpr std::string_view jog_end_name(JogEnd how) {
  return kJogEndNames[static_cast<std::size_t>(how)];
}
// `ended by` this. The axis counts for kLimit only.
inline std::string jog_end_text(JogEnd how, std::uint8_t axis) {
  if (how == JogEnd::kLimit) return "the soft limit of joint " + std::to_string(axis);
  static constexpr std::array<std::string_view, kJogEndNames.size()> kTexts{"its duration",
                                                                            "a time-out of its commands",
                                                                            "a command without a velocity",
                                                                            "a soft limit",
                                                                            "joints that could not move the tool on",
                                                                            "a stop",
                                                                            "a hold",
                                                                            "a fault"};
  return std::string{kTexts[static_cast<std::size_t>(how)]};
}
constexpr std::string_view homing_end_name(HomingEnd how) {
  return kHomingEndNames[static_cast<std::size_t>(how)];
}
// `met` this first.
constexpr std::string_view homing_switch_text(HomingSwitch met) {
  constexpr std::array<std::string_view, 4> kTexts{"no switch", "the home switch", "the home switch at its start",
                                                   "a limit switch"};
  return kTexts[static_cast<std::size_t>(met)];
}
// `axis 3` this.
inline std::string homing_text(const HomingEnded& axis) {
  std::string text = "ended as " + std::string{homing_end_name(axis.how)} + " after " +
                     std::to_string(axis.taken.value()) + " ticks, met " + std::string{homing_switch_text(axis.met)} +
                     " first";
  if (axis.how != HomingEnd::kHomed) return text;
  return text + ", index " + std::to_string(axis.edge_to_index.value()) + " counts from its edge, encoder shifted by " +
         std::to_string(axis.shift.value()) + " counts";
}
constexpr std::string_view refusal_name(Refusal reason) {
  return kRefusalNames[static_cast<std::size_t>(reason)];
}
// What happened to a move that did not start: it was refused, or dropped although the command itself is valid.
constexpr std::string_view refusal_word(Refusal reason) {
  const bool dropped = reason == Refusal::kNotReady || reason == Refusal::kReplaced ||
                       reason == Refusal::kInputTimeout || reason == Refusal::kPartLost;
  return dropped ? "not carried out" : "refused";
}
// `wrist`, `shoulder`, `elbow` of a mask of Singularity.
inline std::vector<std::string_view> singularity_names(std::uint8_t mask) {
  std::vector<std::string_view> names;
  if ((mask & kShoulderSingular) != 0) names.emplace_back("shoulder");
  if ((mask & kWristSingular) != 0) names.emplace_back("wrist");
  if ((mask & kElbowSingular) != 0) names.emplace_back("elbow");
  return names;
}
// `shoulder`, `elbow`, `wrist`, `turns` of a mask of ConfigurationPart.
inline std::vector<std::string_view> configuration_part_names(std::uint8_t mask) {
  std::vector<std::string_view> names;
  if ((mask & kShoulderPart) != 0) names.emplace_back("shoulder");
  if ((mask & kElbowPart) != 0) names.emplace_back("elbow");
  if ((mask & kWristPart) != 0) names.emplace_back("wrist");
  if ((mask & kTurnsPart) != 0) names.emplace_back("turns");
  return names;
}
// The cause alone: `watchdog` of `fault:watchdog`.
constexpr std::string_view cause_of(std::string_view outcome) {
  return outcome.substr(outcome.find(':') + 1);
}
constexpr std::string_view fault_name(FaultCause cause) {
  return cause == FaultCause::kNone ? std::string_view{"none"} : cause_of(outcome_name(cause));
}
// All causes, as in the outcomes but without the prefix.
inline constexpr auto kCauseNames = [] {
  std::array<std::string_view, kOutcomeNames.size() - 1> names{};
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = cause_of(kOutcomeNames[i + 1]);
  return names;
}();

static_assert(outcome_name(FaultCause::kClock) == "fault:clock");
static_assert(cause_of(kControllerSilent) == "controller_silent");
static_assert(state_name(MotionState::kFault) == "fault");
static_assert(shape_name(ProfileShape::kTrapezoid) == "trapezoid");
static_assert(kMoveNames[static_cast<std::size_t>(MoveKind::kDwell)] == "dwell");
static_assert(jog_end_name(JogEnd::kFault) == "fault");
static_assert(refusal_name(Refusal::kNotReferenced) == "not_referenced");
static_assert(homing_end_name(HomingEnd::kFault) == "fault");
static_assert(part_end_name(PartEnd::kFault) == "fault");
static_assert(program_note_name(ProgramNoted::Kind::kOver) == "over");

}  // namespace armature::cosim
