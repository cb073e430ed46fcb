// What the C++ and the C library need of a system that has none. The controller allocates nothing, throws nothing and
// prints nothing; these functions end a core that does. What it calls in each tick is here too, because the libraries
// need more instructions for it (copies of memory: memory.S).

#include <cstddef>
#include <cstdint>

#include "controller/board/exact_numbers.hpp"

extern "C" [[noreturn]] void sleep_for_ever();  // start.S

extern "C" {
[[noreturn]] void abort() {
  sleep_for_ever();
}
[[noreturn]] void __cxa_pure_virtual() {
  sleep_for_ever();
}
int* __errno() {
  static int error;
  return &error;
}

// The compiler calls these with numbers in core registers (RTABI of the ARM, IHI 0043, 4.1.2).
#define ARMATURE_CORE_REGISTERS [[gnu::pcs("aapcs")]]
ARMATURE_CORE_REGISTERS double __aeabi_l2d(std::int64_t value) {
  return armature::board::to_double(value);
}
ARMATURE_CORE_REGISTERS double __aeabi_ul2d(std::uint64_t value) {
  return armature::board::to_double(value);
}
ARMATURE_CORE_REGISTERS std::int64_t __aeabi_d2lz(double value) {
  return armature::board::to_signed(value);
}
ARMATURE_CORE_REGISTERS std::uint64_t __aeabi_d2ulz(double value) {
  return armature::board::to_unsigned(value);
}
double floor(double value) {
  return armature::board::floor_of(value);
}
}

namespace std {
[[noreturn]] void __throw_out_of_range_fmt(const char*, ...) {
  sleep_for_ever();
}
}  // namespace std

void operator delete(void*) noexcept {
  sleep_for_ever();
}
void operator delete(void*, std::size_t) noexcept {
  sleep_for_ever();
}
