// Which commands the arm admits in which state.
#pragma once

#include <cstdint>

#include "controller/pendant/protocol/frame.hpp"

namespace armature::pendant {

enum class Profile : std::uint8_t {
  kStrict,    // Vo 2021: while a program runs, only the emergency stop is executed
  kExtended,  // besides, a running program can be held, ended, and made slower
};

// kOk, or the refusal. The payload must be in its range as well.
[[nodiscard]] Status admission(const Frame& command, State state, Profile profile) noexcept;

}  // namespace armature::pendant
