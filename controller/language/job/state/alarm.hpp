// Why a program cannot continue.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace armature::job {

enum class Alarm : std::uint8_t {
  kNone,
  kUnsupported,
  kRange,
  kDivision,
  kIndex,
  kTypes,
  kNotSet,
  kFrame,
  kTool,
  kToolTurns,
  kRelation,
  kReach,
  kPosture,
  kArc,
  kPin,
  kCalls,
  kLocals,
  kLabel,
  kArguments,
  kUser,
  kAborted,
  kCount,
};

// Element i belongs to Alarm i. The note of an alarm has it after the name of the instruction.
inline constexpr std::array<std::string_view, static_cast<std::size_t>(Alarm::kCount)> kAlarmTexts{
    "no alarm",
    "not supported",
    "a value out of the range of its variable",
    "division by 0, or the root of a negative value",
    "no variable or element of this number",
    "operands of kinds that do not go together",
    "a position variable that is not set",
    "a frame that is not defined",
    "a second tool, of which [[job.tool]] says nothing",
    "a path that turns a tool of [[job.tool]]",
    "points of a frame on one line",
    "a position that the arm cannot reach",
    "no solution in this posture (RCONF) within limits",
    "too many points of a curve",
    "no pin of this number",
    "more than 16 calls within each other",
    "no room for the local variables",
    "no label of this value",
    "no argument of this number",
    "alarm of the user",
    "ended by ABORT",
};
[[nodiscard]] constexpr std::string_view text_of_alarm(Alarm alarm) noexcept {
  return kAlarmTexts[static_cast<std::size_t>(alarm)];
}

}  // namespace armature::job
