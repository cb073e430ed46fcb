// JUnit XML.
#include "cosim/report/format/junit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cosim/report/format/fact_lines.hpp"
#include "tests/cosim/support/sample_summary.hpp"

namespace armature::cosim {
namespace {

using test::sample_summary;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

TEST(Junit, CountsAndEscapes) {
  const std::string xml = junit_xml(
      {{.name = "good", .wall_s = 1.5, .failure = {}, .error = {}, .output = {}},
       {.name = "a<b>&\"c\"", .wall_s = 0.25, .failure = "first\nsecond \x01", .error = {}, .output = "out & in"},
       {.name = "bad", .wall_s = 0, .failure = {}, .error = "no file", .output = {}}});
  EXPECT_THAT(xml, HasSubstr("tests=\"3\" failures=\"1\" errors=\"1\" time=\"1.750\""));
  EXPECT_THAT(xml, HasSubstr("name=\"good\" time=\"1.500\">\n  </testcase>"));
  EXPECT_THAT(xml, HasSubstr("name=\"a&lt;b&gt;&amp;&quot;c&quot;\""));
  EXPECT_THAT(xml, HasSubstr("<failure message=\"first\">first&#10;second \\x01</failure>"));
  EXPECT_THAT(xml, HasSubstr("<system-out>out &amp; in</system-out>"));
  EXPECT_THAT(xml, HasSubstr("<error message=\"no file\">no file</error>"));
  EXPECT_THAT(xml, EndsWith("</testsuite>\n"));
}

TEST(Junit, HasTheFactsOfARunAsProperties) {
  RunSummary summary = sample_summary();
  summary.facts.underruns = 5;
  JunitCase one{.name = "late_core"};
  one.properties = fact_properties(summary);
  const std::string xml = junit_xml({one});
  EXPECT_THAT(xml, HasSubstr("    <properties>\n      <property name=\"outcome\" value=\"fault:following_error\"/>\n"));
  EXPECT_THAT(xml, HasSubstr("<property name=\"underruns\" value=\"5\"/>\n"));
  EXPECT_THAT(xml, HasSubstr("<property name=\"refusals\" value=\"[outside_limits]\"/>\n"));
  EXPECT_THAT(xml, HasSubstr("<property name=\"worst_following_error_deg\" value=\"[0.5, 0, 0, 0, 0, 0.9553]\"/>\n"));
  EXPECT_THAT(xml, Not(HasSubstr("settle_s")));     // not measured
  EXPECT_THAT(xml, Not(HasSubstr("lost_counts")));  // of the other variant
  EXPECT_THAT(junit_xml({{.name = "no run"}}), Not(HasSubstr("propert")));
}

}  // namespace
}  // namespace armature::cosim
