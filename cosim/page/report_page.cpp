#include "cosim/page/report_page.hpp"

#include <string_view>

#include "cosim/page/embedded_files.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/xml_text.hpp"

namespace armature::cosim {
namespace {

// JSON inside a <script> element: without `<`, nothing in it can end the element or begin a comment.
std::string script_json(const nlohmann::ordered_json& data) {
  const std::string json = data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  std::string safe;
  safe.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

// Copies the page up to the mark, then `text` in place of the mark. `rest` begins behind it.
void fill(std::string& page, std::string_view& rest, std::string_view mark, std::string_view text) {
  const std::size_t at = rest.find(mark);
  page.append(rest.substr(0, at)).append(text);
  rest.remove_prefix(at + mark.size());
}

}  // namespace

std::string report_page(const nlohmann::ordered_json& data) {
  const EmbeddedPage parts = embedded_page();
  const std::string run = script_json(data);
  std::string page;
  page.reserve(run.size() + parts.page.size() + parts.style.size() + parts.libraries.size() + parts.scripts.size());
  std::string_view rest = parts.page;
  fill(page, rest, "@TITLE@", xml_text(printable(data["summary"]["scenario"].get<std::string>())) + ": report");
  fill(page, rest, "@STYLE@", parts.style);
  fill(page, rest, "@RUN@", run);
  fill(page, rest, "@LIBRARIES@", parts.libraries);
  fill(page, rest, "@SCRIPTS@", parts.scripts);
  return page.append(rest);
}

}  // namespace armature::cosim
