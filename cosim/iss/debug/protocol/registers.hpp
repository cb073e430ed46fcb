// The registers of a core, as gdb numbers them: r0 to r12, sp, lr, pc, cpsr, d0 to d31, fpscr.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace armature::cosim::iss {

inline constexpr int kPcNumber = 15;
inline constexpr int kFirstDouble = 17;
inline constexpr int kDoubles = 32;
inline constexpr int kRegisters = kFirstDouble + kDoubles + 1;

using Registers = std::array<std::uint64_t, kRegisters>;  // by their numbers

// Of a register: 8 of d0 to d31, else 4.
[[nodiscard]] constexpr int bytes_of_register(int number) {
  return number >= kFirstDouble && number < kFirstDouble + kDoubles ? 8 : 4;
}

// These registers, in this order, in the words that gdb reads (qXfer:features:read).
[[nodiscard]] std::string_view target_description();

}  // namespace armature::cosim::iss
