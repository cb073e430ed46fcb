// Splits the bytes of a connection into lines.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace armature::cosim {

class LineBuffer {
 public:
  struct Line {
    std::string_view text;  // without its end; valid until the next append()
    bool too_long = false;  // longer than the limit; `text` is empty
  };

  explicit LineBuffer(std::size_t longest) : longest_{longest} {}

  // Of the lines that are not complete yet.
  void set_longest(std::size_t longest) { longest_ = longest; }

  // Number of bytes in the buffer: lines not yet returned, and the beginning of the next.
  [[nodiscard]] std::size_t held() const { return buffer_.size() - begin_; }

  void append(std::string_view bytes) {
    buffer_.erase(0, begin_);
    searched_ -= begin_;
    begin_ = 0;
    buffer_ += bytes;
  }

  // Removes all bytes that held() counts.
  std::string take_rest() {
    std::string rest = buffer_.substr(begin_);
    buffer_.clear();
    begin_ = searched_ = 0;
    return rest;
  }

  // The next complete line, if there is one. A line that is longer than the limit is discarded while it arrives, so
  // that the buffer stays small. It is reported when its end has arrived.
  std::optional<Line> next() {
    const std::size_t end = buffer_.find('\n', searched_);
    if (end == std::string::npos) {
      searched_ = buffer_.size();
      if (searched_ - begin_ > longest_) skipping_ = true;
      if (skipping_) begin_ = searched_;
      return std::nullopt;
    }
    const bool too_long = skipping_ || end - begin_ > longest_;
    const Line line{too_long ? std::string_view{} : std::string_view{buffer_}.substr(begin_, end - begin_), too_long};
    begin_ = searched_ = end + 1;
    skipping_ = false;
    return line;
  }

 private:
  std::size_t longest_;
  std::string buffer_;
  std::size_t begin_ = 0;     // of the next line
  std::size_t searched_ = 0;  // no end of a line between begin_ and here
  bool skipping_ = false;     // the line before begin_ was too long already
};

}  // namespace armature::cosim
