// A text that many objects have: copies share it.
#pragma once

#include <memory>
#include <string>
#include <utility>

namespace armature::cosim {

class SharedText {
 public:
  SharedText() = default;
  SharedText(std::string text) : text_{text.empty() ? nullptr : std::make_shared<const std::string>(std::move(text))} {}
  SharedText(const char* text) : SharedText{std::string{text}} {}

  [[nodiscard]] bool empty() const { return text_ == nullptr; }
  [[nodiscard]] const std::string& str() const {
    static const std::string kEmpty;
    return empty() ? kEmpty : *text_;
  }

 private:
  std::shared_ptr<const std::string> text_;  // nullptr: empty
};

}  // namespace armature::cosim
