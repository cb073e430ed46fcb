#include "cosim/cli/run/file_changes.hpp"

#include <sys/stat.h>

#include <thread>

namespace armature::cosim {

void FileChanges::add(const std::filesystem::path& file) {
  states_.try_emplace(file, state_of(file));
}

void FileChanges::restart() {
  states_ = states_now();
  changed_ = false;
}

bool FileChanges::changed() {
  const auto now = std::chrono::steady_clock::now();
  if (!changed_ && now >= next_look_) {
    next_look_ = now + kPause;
    changed_ = states_now() != states_;
  }
  return changed_;
}

bool FileChanges::settled() const {
  const States before = states_now();
  std::this_thread::sleep_for(kPause);
  return states_now() == before;
}

FileChanges::State FileChanges::state_of(const std::filesystem::path& file) {
  struct stat found {};
  if (::stat(file.c_str(), &found) != 0) return {};
  return {.device = static_cast<std::int64_t>(found.st_dev),
          .number = static_cast<std::int64_t>(found.st_ino),
          .size = found.st_size,
          .seconds = found.st_mtim.tv_sec,
          .nanoseconds = found.st_mtim.tv_nsec};
}

FileChanges::States FileChanges::states_now() const {
  States now;
  for (const auto& [file, state] : states_) now.emplace(file, state_of(file));
  return now;
}

}  // namespace armature::cosim
