// The page that lists the scenarios of a check, with links to the reports of those that failed.
#pragma once

#include <string>
#include <vector>

namespace armature::cosim {

struct IndexRow {
  std::string scenario;
  bool passed = false;
  std::string reason;  // why it failed: the first line is shown
  std::string report;  // file beside the page; empty: none
  std::string description{};
  double simulated_s = 0, wall_s = 0;
  std::string picture{};  // SVG of this program; empty: none
};

// Rows of failures come first; otherwise the order stays.
[[nodiscard]] std::string index_page(std::vector<IndexRow> rows);

}  // namespace armature::cosim
