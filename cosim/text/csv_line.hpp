// One line of comma-separated values without quotes, as all tables that armature reads have them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cosim/text/input_error.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {

// Removes the first line from `rest` and returns it without its end, LF or CR LF.
inline std::string_view pop_line(std::string_view& rest) {
  const std::string_view line = rest.substr(0, rest.find('\n'));
  rest.remove_prefix(line.size() == rest.size() ? line.size() : line.size() + 1);
  return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

class CsvLine {
 public:
  // `file` is for messages.
  explicit CsvLine(std::string file) : file_{std::move(file)} {}

  // `text` must stay. `line`: its number in the file; 0: not in a file.
  void set(int line, std::string_view text) {
    line_ = line;
    text_ = text;
    values_.clear();
    while (true) {
      const std::size_t comma = text.find(',');
      values_.push_back(text.substr(0, comma));
      if (comma == std::string_view::npos) return;
      text.remove_prefix(comma + 1);
    }
  }

  [[nodiscard]] int line() const noexcept { return line_; }
  [[nodiscard]] const std::vector<std::string_view>& values() const noexcept { return values_; }
  [[nodiscard]] std::string_view operator[](std::size_t column) const { return values_[column]; }

  // Nothing if not all of the value is a number. `base`: nothing, or that of an integer.
  template <class T, class... Base>
  [[nodiscard]] std::optional<T> number(std::size_t column, Base... base) const {
    return parsed_number<T>(values_[column], base...);
  }

  // Throws InputError with the place of the value.
  [[noreturn]] void fail(std::size_t column, const std::string& message) const {
    const auto at = static_cast<int>(values_[column].data() - text_.data()) + 1;
    throw InputError{Problem{file_, Origin{line_, at, {}}, {}, message}};
  }

 private:
  std::string file_;
  int line_ = 1;
  std::string_view text_;
  std::vector<std::string_view> values_;
};

}  // namespace armature::cosim
