#include "cosim/snapshot/return_points.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <system_error>

#include "cosim/snapshot/copied_process.hpp"

namespace armature::cosim {
namespace {

// How a copy ends that goes back. No other exit code has this value.
constexpr int kGoesBack = 77;

}  // namespace

ReturnPoints::ReturnPoints(int kept) : kept_{kept} {
  void* const memory = ::mmap(nullptr, sizeof(*wanted_), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::system_error{errno, std::generic_category(), "cannot share memory"};
  wanted_ = new (memory) std::int64_t{0};
}

ReturnPoints::~ReturnPoints() {
  ::munmap(wanted_, sizeof(*wanted_));
}

bool ReturnPoints::mark(std::int64_t key) {
  for (bool again = false;; again = true) {
    pid_t copy = -1;
    try {
      copy = copy_this_process(kept_);
    } catch (const std::runtime_error&) {
      if (!again) throw;
      return true;  // this process continues itself
    }
    if (copy == 0) {
      if (count_++ == 0) first_ = key;
      return again;
    }
    const int code = wait_for_end(copy);
    if (code == kGoesBack && key <= *wanted_) continue;
    ::_exit(code < 0 ? EXIT_FAILURE : code);
  }
}

void ReturnPoints::go_back(std::int64_t key) {
  *wanted_ = key;
  ::_exit(kGoesBack);
}

}  // namespace armature::cosim
