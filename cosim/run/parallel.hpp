// Independent pieces of work on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace armature::cosim {

// Calls `work(i, thread)` for each i below `count`, in this order, up to `jobs` at a time. `thread`: 0 to jobs - 1;
// calls of the same thread do not overlap. When a call returns false or throws, no more are begun. Returns when all
// have ended; throws what a call has thrown.
void for_each_in_parallel(std::size_t count, int jobs, const std::function<bool(std::size_t i, int thread)>& work);

}  // namespace armature::cosim
