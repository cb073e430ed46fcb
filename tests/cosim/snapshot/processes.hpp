// What tests see of processes.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <fstream>
#include <string>
#include <thread>

namespace armature::cosim::test {

// A process that has ended may stay as a zombie until the first process of the machine has noticed it.
inline bool has_ended(pid_t process) {
  std::ifstream file{"/proc/" + std::to_string(process) + "/stat"};
  std::string status;
  if (!std::getline(file, status)) return true;
  const char state = status[status.rfind(')') + 2];
  return state == 'Z' || state == 'X';
}

// Waits for that.
inline bool ends(pid_t process) {
  for (int tries = 0; tries < 2'000; ++tries) {
    if (has_ended(process)) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds{5});
  }
  return false;
}

}  // namespace armature::cosim::test
