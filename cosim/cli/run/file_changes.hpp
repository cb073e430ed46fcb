// Notices that files change. It looks at their times, sizes and numbers: that works on every file system, and with
// editors that replace a file instead of writing into it.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>

namespace armature::cosim {

class FileChanges {
 public:
  // From now on this file counts, whether it exists or not. A file that counts already keeps its earlier state.
  void add(const std::filesystem::path& file);
  // All files count as unchanged now.
  void restart();
  // Whether a file has changed since it was added or since restart(). It looks at most ten times a second, so a caller
  // may ask as often as it likes.
  [[nodiscard]] bool changed();
  // Whether no file changes for a tenth of a second: whoever writes has finished.
  [[nodiscard]] bool settled() const;

  static constexpr std::chrono::milliseconds kPause{100};

 private:
  struct State {
    std::int64_t device = 0, number = 0, size = 0, seconds = 0, nanoseconds = 0;  // all 0: there is no such file
    friend bool operator==(const State&, const State&) = default;
  };
  using States = std::map<std::filesystem::path, State>;
  [[nodiscard]] static State state_of(const std::filesystem::path& file);
  [[nodiscard]] States states_now() const;

  States states_;
  std::chrono::steady_clock::time_point next_look_{};
  bool changed_ = false;
};

}  // namespace armature::cosim
