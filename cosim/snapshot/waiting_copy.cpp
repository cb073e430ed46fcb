#include "cosim/snapshot/waiting_copy.hpp"

#include <csignal>

#include "cosim/snapshot/copied_process.hpp"

namespace armature::cosim {

WaitingCopy::~WaitingCopy() {
  if (process_ == 0) return;
  end();
  wait_for_end(process_);
}

void WaitingCopy::end() {
  ::kill(process_, SIGKILL);
}

std::variant<WaitingCopy, WokenCopy> take_snapshot() {
  auto [ours, of_copy] = MessageChannel::pair();
  const pid_t copy = copy_this_process(of_copy.descriptor());
  if (copy != 0) return WaitingCopy{copy, std::move(ours)};
  ours.close();
  if (!of_copy.wait()) ::_exit(EXIT_SUCCESS);
  return WokenCopy{std::move(of_copy)};
}

}  // namespace armature::cosim
