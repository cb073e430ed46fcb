// The report of a run as one HTML page. It needs no other file and no network.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace armature::cosim {

// `data`: as run_data() gives it. Texts in it come from files of users; nothing in them can run in the page.
[[nodiscard]] std::string report_page(const nlohmann::ordered_json& data);

}  // namespace armature::cosim
