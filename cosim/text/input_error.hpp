// Problems in files and options that users write, and the exception that carries all of them at once.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/text/shared_text.hpp"

namespace armature::cosim {

// Where a key or a value was written: in a file, or in a `--set` override.
struct Origin {
  int line = 0;              // from 1; 0 = the file as a whole
  int column = 0;            // from 1, in code points
  SharedText override_text;  // "key=value" of --set, which each value in it has; empty for a file
};

// `file:12:8`, or `--set key=value` for an override; the file alone where no line is known.
[[nodiscard]] std::string place_text(const std::string& file, const Origin& origin);

struct Problem {
  std::string file;
  Origin origin;
  std::string key;      // full path, `move[2].target_deg`; empty if the problem is at no key
  std::string message;  // what was expected and what was found

  // `file:12:8: move[2].target_deg: message`, or `--set key=value: ...` for an override. One printable line
  // (printable.hpp), whatever the file holds.
  [[nodiscard]] std::string text() const;
};

// Bad input (exit code 2). what() has one line per problem, in the order of the file.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Problem> problems);
  explicit InputError(const Problem& problem);
  InputError(const std::string& file, const std::string& message);
  [[nodiscard]] const std::vector<Problem>& problems() const noexcept { return problems_; }

 private:
  std::vector<Problem> problems_;
};

// Collects the problems of one file, so that the user sees all of them: the first kMaxKept in full, then their
// number.
class ProblemList {
 public:
  static constexpr std::size_t kMaxKept = 100;

  explicit ProblemList(std::string file) : file_{std::move(file)} {}
  void add(const Origin& origin, std::string_view key, std::string message);
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] bool is_full() const noexcept { return size_ > kMaxKept; }  // more of them are only counted
  // Moves the problems to the end of `all`, sorted by place (overrides last).
  void move_to(std::vector<Problem>& all);

 private:
  std::string file_;
  std::vector<Problem> problems_;
  std::size_t size_ = 0;
};

}  // namespace armature::cosim
