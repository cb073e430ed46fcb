// What a program reports, in words.
#pragma once

#include <string>
#include <string_view>

#include "controller/message/program_noted.hpp"

namespace armature::cosim {

// The text behind the name of the line: `alarm: the path leaves the reach of the arm`, `message: "Hello"`, `ended`.
// A line that begins is `interpreted`, in the robot language with its instruction: the arm may be some lines behind.
[[nodiscard]] std::string program_note_text(const ProgramNoted& note);

// Why a run ended before its duration: `the run ends here: [expect] does not state program_end = "alarm"`.
[[nodiscard]] std::string early_end_text(std::string_view program_end);

}  // namespace armature::cosim
