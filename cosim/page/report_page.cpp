#include "cosim/page/report_page.hpp"

#include <string_view>
#include <utility>

#include "cosim/page/embedded_files.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/sha256.hpp"
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

ReportPage report_page(nlohmann::ordered_json data, const PageOptions& options) {
  nlohmann::ordered_json page_data = {{"shown", nullptr}, {"digest", ""}};
  if (const auto& shown = options.shown) {
    page_data["shown"] = {{"from", shown->from_s}, {"to", shown->to_s}, {"time", shown->time_s}};
  }
  ReportPage result;
  result.digest = sha256_hex(script_json(data) + page_data.dump());
  if (options.reloads) page_data["digest"] = result.digest;
  data["page"] = std::move(page_data);
  const EmbeddedPage parts = embedded_page();
  const std::string run = script_json(data);
  std::string& page = result.text;
  page.reserve(run.size() + parts.page.size() + parts.style.size() + parts.libraries.size() + parts.scripts.size());
  std::string_view rest = parts.page;
  fill(page, rest, "@SOURCES@", options.reloads ? " 'self' file:" : "");
  fill(page, rest, "@TITLE@", xml_text(printable(data["summary"]["scenario"].get<std::string>())) + ": report");
  fill(page, rest, "@STYLE@", parts.style);
  fill(page, rest, "@RUN@", run);
  fill(page, rest, "@LIBRARIES@", parts.libraries);
  fill(page, rest, "@SCRIPTS@", parts.scripts);
  page.append(rest);
  return result;
}

std::string reload_script(const std::string& digest, const std::string& problem) {
  return "reportChanged(" + script_json({{"digest", digest}, {"problem", problem}}) + ");\n";
}

}  // namespace armature::cosim
