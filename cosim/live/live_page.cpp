#include "cosim/live/live_page.hpp"

#include "cosim/page/embedded_files.hpp"
#include "cosim/page/page_marks.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/xml_text.hpp"

namespace armature::cosim {

std::string live_page(const std::string& name) {
  const EmbeddedPage parts = embedded_live_page();
  const std::string title = xml_text(printable(name)) + ": live";
  return with_marks(parts.page, {{"@TITLE@", title},
                                 {"@STYLE@", parts.style},
                                 {"@LIBRARIES@", embedded_page().libraries},
                                 {"@SCRIPTS@", parts.scripts}});
}

}  // namespace armature::cosim
