// Where a printer writes its text, piece by piece.
#pragma once

#include <cstddef>
#include <string_view>

namespace armature {

class TextSink {
 public:
  virtual void write(std::string_view text) noexcept = 0;

 protected:
  ~TextSink() = default;  // never owned through this interface
};

// Counts characters and drops them.
class TextLength final : public TextSink {
 public:
  void write(std::string_view text) noexcept override { size_ += text.size(); }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }

 private:
  std::size_t size_ = 0;
};

}  // namespace armature
