// Text inside XML documents: JUnit files, pictures, pages.
#pragma once

#include <string>
#include <string_view>

namespace armature::cosim {

// The text with `& < > "` and line ends as entities. It can be the content of an element or the value of an attribute
// in double quotes.
[[nodiscard]] inline std::string xml_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\n':
        escaped += "&#10;";  // XML readers replace a plain one in an attribute by a space
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

}  // namespace armature::cosim
