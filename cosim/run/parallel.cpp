#include "cosim/run/parallel.hpp"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace armature::cosim {

void for_each_in_parallel(std::size_t count, int jobs, const std::function<bool(std::size_t i, int thread)>& work) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr error;
  const auto take_all = [&](int thread) {
    try {
      for (std::size_t i = next++; i < count; i = next++) {
        if (!work(i, thread)) next = count;
      }
    } catch (...) {
      const std::scoped_lock lock{mutex};
      error = std::current_exception();
      next = count;
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (int thread = 1; thread < jobs; ++thread) helpers.emplace_back(take_all, thread);
    take_all(0);
  }
  if (error) std::rethrow_exception(error);
}

}  // namespace armature::cosim
