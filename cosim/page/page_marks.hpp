// The marks of an embedded page, such as @TITLE@.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace armature::cosim {

struct PageMark {
  std::string_view mark;
  std::string_view text;
};

// The page with a text in place of each mark. The page has all of them, in this order.
[[nodiscard]] inline std::string with_marks(std::string_view page, std::initializer_list<PageMark> marks) {
  std::size_t size = page.size();
  for (const PageMark& one : marks) size += one.text.size();
  std::string filled;
  filled.reserve(size);
  for (const PageMark& one : marks) {
    const std::size_t at = page.find(one.mark);
    filled.append(page.substr(0, at)).append(one.text);
    page.remove_prefix(at + one.mark.size());
  }
  return filled.append(page);
}

}  // namespace armature::cosim
