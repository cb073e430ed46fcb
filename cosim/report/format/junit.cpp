#include "cosim/report/format/junit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "cosim/text/printable.hpp"
#include "cosim/text/xml_text.hpp"

namespace armature::cosim {
namespace {

std::string escaped(std::string_view text) {
  return xml_text(printable_lines(text));
}

void add_problem(std::string& out, std::string_view element, const std::string& text) {
  if (text.empty()) return;
  fmt::format_to(std::back_inserter(out), "    <{0} message=\"{1}\">{2}</{0}>\n", element,
                 escaped(text.substr(0, text.find('\n'))), escaped(text));
}

void add_properties(std::string& out, const JunitCase& one) {
  if (one.properties.empty() && one.report.empty()) return;
  out += "    <properties>\n";
  if (!one.report.empty()) {
    fmt::format_to(std::back_inserter(out), "      <property name=\"report\" value=\"{}\"/>\n", escaped(one.report));
  }
  for (const auto& [name, value] : one.properties) {
    fmt::format_to(std::back_inserter(out), "      <property name=\"{}\" value=\"{}\"/>\n", escaped(name),
                   escaped(value));
  }
  out += "    </properties>\n";
}

}  // namespace

std::string junit_xml(const std::vector<JunitCase>& cases) {
  const auto failures = std::count_if(cases.begin(), cases.end(), [](const auto& c) { return !c.failure.empty(); });
  const auto errors = std::count_if(cases.begin(), cases.end(), [](const auto& c) { return !c.error.empty(); });
  double wall_s = 0;
  for (const JunitCase& one : cases) wall_s += one.wall_s;
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  fmt::format_to(std::back_inserter(out),
                 "<testsuite name=\"armature check\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\">\n",
                 cases.size(), failures, errors, wall_s);
  for (const JunitCase& one : cases) {
    fmt::format_to(std::back_inserter(out), "  <testcase classname=\"scenarios\" name=\"{}\" time=\"{:.3f}\">\n",
                   escaped(printable(one.name)), one.wall_s);
    add_properties(out, one);
    add_problem(out, "failure", one.failure);
    add_problem(out, "error", one.error);
    if (!one.output.empty()) {
      fmt::format_to(std::back_inserter(out), "    <system-out>{}</system-out>\n", escaped(one.output));
    }
    out += "  </testcase>\n";
  }
  return out + "</testsuite>\n";
}

}  // namespace armature::cosim
