#include "controller/language/job/execute/alarm_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

#include "tests/controller/language/job/job_text.hpp"

namespace armature::job {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr const char* kEnd = "; when executed, it is an alarm";

std::vector<std::string> warnings_of(test::Jobs& jobs, const MachineSettings& settings = {}) {
  jobs.said.warnings.clear();
  warn_of_alarms(*jobs.memory, settings, jobs.said);
  for (std::string& warning : jobs.said.warnings) {
    EXPECT_TRUE(warning.ends_with(kEnd)) << warning;
    warning.resize(warning.size() - std::string{kEnd}.size());
  }
  return jobs.said.warnings;
}

TEST(AlarmCheck, NamesInstructionsAndFormsThatAreNotSupported) {
  test::Jobs jobs;
  ASSERT_TRUE(
      jobs.load(test::moving_job_of("MOVJ C00000\nMOVJ C00001 +MOVJ EC00001\nARCON ASF#(1)\nMACRO1 MJ#(3)\n"
                                    "'ARCOF\nMOVL C00002 V=10.0 SRCH RIN#(1)=ON T=5.00\nCOMARCON\n")));
  EXPECT_THAT(
      warnings_of(jobs),
      ElementsAre("a.jbi:16:1: MOVJ: external axes, a second group and searches are not supported",
                  "a.jbi:17:1: ARCON: not supported without its output in [job]", "a.jbi:18:1: MACRO1: not supported",
                  "a.jbi:20:1: MOVL: external axes, a second group and searches are not supported",
                  "a.jbi:21:1: COMARCON: not supported without its output in [job]"));
  MachineSettings settings;
  settings.device_pin = {1, 0, 0};
  EXPECT_EQ(warnings_of(jobs, settings).size(), 3U);
}

TEST(AlarmCheck, NamesASecondToolAndPositionsInAToolFrame) {
  test::Jobs jobs;
  ASSERT_TRUE(
      jobs.load("/JOB\n//NAME A\n//POS\n///NPOS 5,0,0,0,0,0\n///TOOL 2\n///POSTYPE BASE\n///RECTAN\nC0=1,2,3,4,5,6\n"
                "///TOOL 3\nC1=1,2,3,4,5,6\n///POSTYPE TOOL\nC2=1,2,3,4,5,6\n///POSTYPE PULSE\n///PULSE\n"
                "C3=1,2,3,4,5,6\nC4=1,2,3,4,5,6\n//INST\nNOP\nMOVL C0\nMOVJ C1\nMOVL C2\nMOVJ C3\nMOVL C4\nEND\n"));
  EXPECT_THAT(warnings_of(jobs), ElementsAre("a.jbi:20:1: MOVJ: TOOL 3 besides TOOL 2 needs [[job.tool]]",
                                             "a.jbi:21:1: MOVL: a position in the frame of a tool is not supported",
                                             "a.jbi:23:1: MOVL: TOOL 3 besides TOOL 2 needs [[job.tool]]"));
  MachineSettings settings;
  settings.flange_T_tool[3] = Transform{};
  EXPECT_EQ(warnings_of(jobs, settings).size(), 1U);
}

TEST(AlarmCheck, SaysNothingOfAProgramThatItSupports) {
  test::Jobs jobs;
  ASSERT_TRUE(jobs.load(test::moving_job_of("MOVJ C00000 VJ=5.00\nMOVL C00001 V=100.0\nDOUT OT#(1) ON\n")));
  EXPECT_THAT(warnings_of(jobs), IsEmpty());
}

}  // namespace
}  // namespace armature::job
