#include "cosim/page/index_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "cosim/text/printable.hpp"
#include "cosim/text/xml_text.hpp"

namespace armature::cosim {
namespace {

constexpr std::string_view kIndexHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'">
<title>armature check</title>
<style>
body { margin: 24px; font: 14px/1.5 system-ui, "DejaVu Sans", Verdana, sans-serif; color: #1f2328; }
table { border-collapse: collapse; }
td, th { padding: 4px 16px 4px 0; border-bottom: 1px solid #eaeef2; text-align: left; vertical-align: top; }
.passed { color: #1a7f37; }
.failed { color: #cf222e; font-weight: 600; }
</style>
</head>
<body>
)";

// A file name as the address of a link.
std::string link_to(std::string_view name) {
  constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~";
  std::string link;
  for (const char c : name) {
    if (kPlain.find(c) != std::string_view::npos) {
      link += c;
    } else {
      fmt::format_to(std::back_inserter(link), "%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return link;
}

std::string index_row(const IndexRow& row) {
  const std::string name = xml_text(printable(row.scenario));
  const std::string link = row.report.empty() ? name : fmt::format("<a href=\"{}\">{}</a>", link_to(row.report), name);
  const std::string_view verdict = row.passed ? "passed" : "failed";
  return fmt::format("<tr><td class=\"{0}\">{0}</td><td>{1}</td><td>{2}</td></tr>\n", verdict, link,
                     xml_text(printable(row.reason.substr(0, row.reason.find('\n')), kShowAll)));
}

}  // namespace

std::string index_page(std::vector<IndexRow> rows) {
  std::stable_partition(rows.begin(), rows.end(), [](const IndexRow& row) { return !row.passed; });
  const auto failed = std::ranges::count(rows, false, &IndexRow::passed);
  std::string page{kIndexHead};
  fmt::format_to(std::back_inserter(page), "<h1>{} passed, {} failed</h1>\n<table>\n", std::ssize(rows) - failed,
                 failed);
  for (const IndexRow& row : rows) page += index_row(row);
  return page + "</table>\n</body>\n</html>\n";
}

}  // namespace armature::cosim
