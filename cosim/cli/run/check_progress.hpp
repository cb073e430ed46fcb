// What `armature check` is doing, on one line of a terminal. It is not part of any result.
#pragma once

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace armature::cosim {

// The caller lets one thread at a time call it.
class CheckProgress {
 public:
  // Writes to `out`. If not `enabled` (see stderr_is_terminal), it writes nothing.
  CheckProgress(std::ostream& out, std::size_t total, bool enabled) : out_{out}, total_{total}, enabled_{enabled} {}
  CheckProgress(const CheckProgress&) = delete;
  CheckProgress& operator=(const CheckProgress&) = delete;
  ~CheckProgress() { clear(); }

  void begin(const std::string& scenario);
  void end(const std::string& scenario);
  // Removes the line, before something else is written to the terminal.
  void clear();

 private:
  void draw();

  std::ostream& out_;
  std::size_t total_;
  bool enabled_;
  std::size_t done_ = 0;
  std::vector<std::string> running_;
  bool drawn_ = false;
};

}  // namespace armature::cosim
