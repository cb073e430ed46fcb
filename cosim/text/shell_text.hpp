// Commands in messages that a user can copy into a shell.
#pragma once

#include <string>
#include <string_view>

namespace armature::cosim {

// The word in a form that a POSIX shell reads as one argument. It is quoted only if needed.
[[nodiscard]] std::string shell_word(std::string_view word);

}  // namespace armature::cosim
