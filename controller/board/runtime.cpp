// What the C++ and the C library need of a system that has none. The controller allocates nothing, throws nothing and
// prints nothing; these functions end a core that does.

#include <cstddef>

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
