// The parts of the pages that the build embeds into the program (embed.cmake).
#pragma once

#include <string_view>

namespace armature::cosim {

struct EmbeddedPage {
  std::string_view page;       // page.html, with @NAME@ for its parts
  std::string_view style;      // CSS
  std::string_view libraries;  // JavaScript of Debian's packages
  std::string_view scripts;    // JavaScript of web/
};

[[nodiscard]] EmbeddedPage embedded_page();  // the report
// Of `armature live`. It has the libraries of the report, which are embedded once; its own are empty.
[[nodiscard]] EmbeddedPage embedded_live_page();

}  // namespace armature::cosim
