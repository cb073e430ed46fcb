// What a program reports, in words.
#pragma once

#include <string>

#include "controller/event/program_noted.hpp"

namespace armature::cosim {

// The text behind the name of the line: `alarm: the path leaves the reach of the arm`, `message: "Hello"`, `ended`.
// A line that begins is `interpreted`, in the robot language with its instruction: the arm may be some lines behind.
[[nodiscard]] std::string program_note_text(const ProgramNoted& note);

}  // namespace armature::cosim
