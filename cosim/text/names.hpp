// Texts of the controller's enumerations that are more than their word (controller/base/words.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "controller/base/words.hpp"
#include "controller/kinematics/configuration.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/message/command.hpp"
#include "controller/message/event.hpp"
#include "controller/message/telemetry.hpp"

namespace armature::cosim {

// How a run ended: completed, or in the state kFault with a cause, `fault:watchdog`.
inline constexpr std::string_view kCompleted = "completed";
// The controller cannot report this cause: the servo enables dropped, and the controller did not notice.
inline constexpr std::string_view kControllerSilent = "controller_silent";
// For a run that the user ended. [expect] does not have this outcome.
inline constexpr std::string_view kInterruptedOutcome = "interrupted";

// All causes why servo enables drop.
inline constexpr auto kCauses = [] {
  std::array<std::string_view, kWordsOf<FaultCause>.size()> causes{};
  for (std::size_t i = 1; i < causes.size(); ++i) causes[i - 1] = kWordsOf<FaultCause>[i];
  causes.back() = kControllerSilent;
  return causes;
}();
// All outcomes: `completed`, then `fault:` and each cause.
[[nodiscard]] inline const std::vector<std::string>& outcomes() {
  static const std::vector<std::string> kOutcomes = [] {
    std::vector<std::string> names{std::string{kCompleted}};
    for (const std::string_view cause : kCauses) names.push_back("fault:" + std::string{cause});
    return names;
  }();
  return kOutcomes;
}
[[nodiscard]] inline std::string_view outcome_of(FaultCause cause) {
  return outcomes()[static_cast<std::size_t>(cause)];
}
// The cause alone: `watchdog` of `fault:watchdog`.
constexpr std::string_view cause_of(std::string_view outcome) {
  return outcome.substr(outcome.find(':') + 1);
}

// How a program ended. The last two: the run ended before the program, or before its start.
inline constexpr std::array<std::string_view, 8> kProgramEnds{"ended",  "alarm", "stopped", "aborted",
                                                              "paused", "held",  "running", "waiting"};

// As the scenario calls its type; an arc about an axis is an `arc`, a `circle` or a `helix`. A circle is an arc that
// ends where it begins.
inline std::string_view move_name(const MoveStarted& move) {
  if (move.kind == MoveKind::kArc && move.path.advance_mm != 0) return "helix";
  if (move.kind == MoveKind::kArc && move.path.start_mm == move.path.end_mm) return "circle";
  return word_of(move.kind);
}
// The joint or tool that is too fast on a path: `joint 4` for axis 4, or `the tool`, in a rounded corner, for 0.
inline std::string_view mover_name(std::uint8_t axis) {
  static constexpr std::array<std::string_view, kAxes + 1> kNames{"the tool", "joint 1", "joint 2", "joint 3",
                                                                  "joint 4",  "joint 5", "joint 6"};
  return kNames[axis];
}
// `ended by` this. The axis counts for kLimit only.
inline std::string jog_end_text(JogEnd how, std::uint8_t axis) {
  if (how == JogEnd::kLimit) return "the soft limit of joint " + std::to_string(axis);
  static constexpr std::array<std::string_view, kWordsOf<JogEnd>.size()> kTexts{
      "its duration",
      "a time-out of its commands",
      "a command without a velocity",
      "a soft limit",
      "joints that could not move the tool on",
      "a stop",
      "a hold",
      "a fault"};
  return std::string{kTexts[static_cast<std::size_t>(how)]};
}
// `met` this first.
constexpr std::string_view homing_switch_text(HomingSwitch met) {
  constexpr std::array<std::string_view, kWordsOf<HomingSwitch>.size()> kTexts{
      "no switch", "the home switch", "the home switch at its start", "a limit switch"};
  return kTexts[static_cast<std::size_t>(met)];
}
// `axis 3` this.
inline std::string homing_text(const HomingEnded& axis) {
  std::string text = "ended as " + std::string{word_of(axis.how)} + " after " + std::to_string(axis.taken.value()) +
                     " ticks, met " + std::string{homing_switch_text(axis.met)} + " first";
  if (axis.how != HomingEnd::kHomed) return text;
  return text + ", index " + std::to_string(axis.edge_to_index.value()) + " counts from its edge, encoder shifted by " +
         std::to_string(axis.shift.value()) + " counts";
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

}  // namespace armature::cosim
