#include "cosim/page/report_page.hpp"

#include <string_view>
#include <utility>

#include "cosim/page/embedded_files.hpp"
#include "cosim/page/page_marks.hpp"
#include "cosim/text/json.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/sha256.hpp"
#include "cosim/text/xml_text.hpp"

namespace armature::cosim {
namespace {

// JSON inside a <script> element: without `<`, nothing in it can end the element or begin a comment.
std::string script_json(const nlohmann::ordered_json& data) {
  const std::string json = compact_text(data);
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
  const std::string title = xml_text(printable(data["summary"]["scenario"].get<std::string>())) + ": report";
  result.text = with_marks(parts.page, {{"@SOURCES@", options.reloads ? " 'self' file:" : ""},
                                        {"@TITLE@", title},
                                        {"@STYLE@", parts.style},
                                        {"@RUN@", run},
                                        {"@LIBRARIES@", parts.libraries},
                                        {"@SCRIPTS@", parts.scripts}});
  return result;
}

std::string reload_script(const std::string& digest, const std::string& problem) {
  return "reportChanged(" + script_json({{"digest", digest}, {"problem", problem}}) + ");\n";
}

}  // namespace armature::cosim
