// The report of a run as one HTML page. It needs no other file and no network.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace armature::cosim {

// The part of the run that the page shows first, and the time of its cursors.
struct ShownPart {
  double from_s = 0, to_s = 0, time_s = 0;
};

struct PageOptions {
  std::optional<ShownPart> shown{};  // none: the whole run, at its start
  // The page looks for a newer report: it runs the script kReloadFile beside it, again and again.
  bool reloads = false;
};

inline constexpr const char* kReloadFile = "reload.js";

struct ReportPage {
  std::string text;
  std::string digest;  // of its content
};

// `data`: as run_data() gives it. Texts in it come from files of users; nothing in them can run in the page.
[[nodiscard]] ReportPage report_page(nlohmann::ordered_json data, const PageOptions& options = {});

// The script kReloadFile: the digest of the report that is there, and the error that prevents a newer one, if any.
[[nodiscard]] std::string reload_script(const std::string& digest, const std::string& problem);

}  // namespace armature::cosim
