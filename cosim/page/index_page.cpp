#include "cosim/page/index_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "cosim/page/embedded_files.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/xml_text.hpp"

namespace armature::cosim {
namespace {

constexpr std::string_view kIndexHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<meta name="color-scheme" content="light dark">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'">
<title>armature check</title>
<style>
)";
constexpr std::string_view kIndexStyle = R"(
h1 { font-size: 21px; }
table { border-collapse: collapse; }
td, th { padding: 8px 18px 8px 0; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }
th { padding-bottom: 2px; font-size: 11px; font-weight: 400; color: var(--soft); }
td.number { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
td p { margin: 2px 0 0; max-width: 44em; overflow-wrap: anywhere; }
td .description { color: var(--soft); }
td a, td strong { font-size: 15px; font-weight: 600; color: var(--text); }
td a { color: var(--accent); }
svg { display: block; }
</style>
</head>
<body>
)";
constexpr std::string_view kTableHead = "<tr><th></th><th></th><th>scenario</th><th>simulated</th><th>took</th></tr>\n";

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
  const std::string link = row.report.empty() ? fmt::format("<strong>{}</strong>", name)
                                              : fmt::format("<a href=\"{}\">{}</a>", link_to(row.report), name);
  const std::string_view verdict = row.passed ? "passed" : "failed";
  const std::string reason = xml_text(printable(row.reason.substr(0, row.reason.find('\n')), kShowAll));
  std::string text =
      fmt::format("<tr><td><span class=\"verdict {0}\">{0}</span></td><td>{1}</td><td>{2}", verdict, row.picture, link);
  if (!row.description.empty())
    text += fmt::format("<p class=\"description\">{}</p>", xml_text(printable(row.description)));
  if (!reason.empty()) text += fmt::format("<p class=\"failure\">{}</p>", reason);
  return text + fmt::format("</td><td class=\"number\">{:.3f} s</td><td class=\"number\">{:.1f} s</td></tr>\n",
                            row.simulated_s, row.wall_s);
}

}  // namespace

std::string index_page(std::vector<IndexRow> rows) {
  std::stable_partition(rows.begin(), rows.end(), [](const IndexRow& row) { return !row.passed; });
  const auto failed = std::ranges::count(rows, false, &IndexRow::passed);
  std::string page{kIndexHead};
  page.append(embedded_page().style).append(kIndexStyle);
  fmt::format_to(std::back_inserter(page), "<h1>{} passed, {} failed</h1>\n<table>\n", std::ssize(rows) - failed,
                 failed);
  page += kTableHead;
  for (const IndexRow& row : rows) page += index_row(row);
  return page + "</table>\n</body>\n</html>\n";
}

}  // namespace armature::cosim
