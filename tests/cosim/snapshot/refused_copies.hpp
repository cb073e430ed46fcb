// A host that refuses fork(), as one does whose user has all the processes that he may have.
#pragma once

#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>

namespace armature::cosim::test {

// From now on, for this process: call it in a process of its own (EXPECT_EXIT). The limit does not hold for root.
inline void refuse_copies() {
  constexpr uid_t kNobody = 65534;
  if (::geteuid() == 0 && ::setresuid(kNobody, kNobody, kNobody) != 0) std::abort();
  ::prctl(PR_SET_DUMPABLE, 1);  // else it may not list its own open files, as another user
  const rlimit none{0, 0};
  if (::setrlimit(RLIMIT_NPROC, &none) != 0) std::abort();
}

}  // namespace armature::cosim::test
