// Points in the life of a process to which it can go back, with all its memory.
//
//   ReturnPoints points{channel.descriptor()};
//   const bool back = points.mark(7);  // false
//   ...
//   points.go_back(9);                 // the line of mark(7) returns again, with true
//
// At each point the process makes a copy of itself and waits; the copy continues. To go back, the copies behind a point
// end, and the process that waits there makes a new copy. So a process is the parent of all that comes after its point,
// and no process remains when the first one ends. copied_process.hpp says what a copy does with files.
#pragma once

#include <cstddef>
#include <cstdint>

namespace armature::cosim {

class ReturnPoints {
 public:
  // All copies keep the descriptor `kept`. Throws std::system_error.
  explicit ReturnPoints(int kept);
  ReturnPoints(const ReturnPoints&) = delete;
  ReturnPoints& operator=(const ReturnPoints&) = delete;
  ~ReturnPoints();

  // A point. `key` is above that of the point before. Returns false at once, and true each time that the process has
  // gone back here; the points behind it are gone then, and so is this one if the host allows no further copy. Throws
  // std::runtime_error when the first copy cannot be made.
  bool mark(std::int64_t key);
  // Whether there is a point whose key is not above `key`.
  [[nodiscard]] bool can_go_back(std::int64_t key) const { return count_ > 0 && first_ <= key; }
  // Goes back to the latest one. Ends all processes when there is none.
  [[noreturn]] void go_back(std::int64_t key);

  // Points that exist.
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  int kept_;
  std::int64_t* wanted_;  // key of go_back(), in memory that all copies share
  std::size_t count_ = 0;
  std::int64_t first_ = 0;  // key of the first one
};

}  // namespace armature::cosim
