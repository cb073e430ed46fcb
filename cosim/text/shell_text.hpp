// Commands in messages that a user can copy into a shell.
#pragma once

#include <string>
#include <string_view>

namespace armature::cosim {

// The word as a POSIX shell takes it for one argument: quoted only where that is needed.
[[nodiscard]] std::string shell_word(std::string_view word);

}  // namespace armature::cosim
