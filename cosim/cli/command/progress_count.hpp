// How many parts of a work are done, on one line of the terminal.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace armature::cosim {

class ProgressCount {
 public:
  // `total` parts, which `name` names in the plural. It writes nothing if `quiet`, and if stderr is no terminal.
  ProgressCount(std::size_t total, std::string name, bool quiet);
  ProgressCount(const ProgressCount&) = delete;
  ProgressCount& operator=(const ProgressCount&) = delete;
  ~ProgressCount();  // clears the line

  // Takes the number of those that are done; must not outlive this. Empty: it writes nothing.
  [[nodiscard]] std::function<void(std::size_t)> listener() const;

 private:
  std::size_t total_;
  std::string name_;
  bool shown_;
};

}  // namespace armature::cosim
