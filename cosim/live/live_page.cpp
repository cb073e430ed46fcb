#include "cosim/live/live_page.hpp"

#include <string_view>

#include "cosim/page/embedded_files.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/xml_text.hpp"

namespace armature::cosim {
namespace {

// Copies the page up to the mark, then `text` in place of the mark. `rest` begins behind it.
void fill_mark(std::string& page, std::string_view& rest, std::string_view mark, std::string_view text) {
  const std::size_t at = rest.find(mark);
  page.append(rest.substr(0, at)).append(text);
  rest.remove_prefix(at + mark.size());
}

}  // namespace

std::string live_page(const std::string& name) {
  const EmbeddedPage parts = embedded_live_page();
  std::string page;
  page.reserve(parts.page.size() + parts.style.size() + parts.libraries.size() + parts.scripts.size());
  std::string_view rest = parts.page;
  fill_mark(page, rest, "@TITLE@", xml_text(printable(name)) + ": live");
  fill_mark(page, rest, "@STYLE@", parts.style);
  fill_mark(page, rest, "@LIBRARIES@", parts.libraries);
  fill_mark(page, rest, "@SCRIPTS@", parts.scripts);
  page.append(rest);
  return page;
}

}  // namespace armature::cosim
