// Names of program files: the language that the end of a name tells, and the files of the parts of a program. Upper and
// lower case are the same, because many controllers write upper case.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "controller/language/store/program_files.hpp"

namespace armature::cosim {

// For messages: "expected a file that " this.
inline constexpr std::string_view kEndsLikeProgram = "ends in .ngc, .nc, .gcode or .jbi";

// Of a file, by the end of its name. kNone: it is no program.
[[nodiscard]] ProgramLanguage program_language(std::string_view file);

// The file of a subroutine or a job in a folder, such as NAME.ngc; nothing if there is none. Of several it is the one
// that has exactly this name, then the first one in the order of the alphabet.
[[nodiscard]] std::optional<std::filesystem::path> find_program(const std::filesystem::path& folder,
                                                                std::string_view name, ProgramLanguage language);

}  // namespace armature::cosim
