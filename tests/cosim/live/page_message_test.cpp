// Messages of the page that are wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

#include "tests/cosim/live/live_page.hpp"

namespace armature::cosim {
namespace {

using test::live_scenario_of;
using test::PlainPage;
using testing::HasSubstr;

TEST(PageMessage, MalformedMessagesGetAnErrorAndDoNothing) {
  PlainPage page{live_scenario_of("pendant_jog", "strict")};
  page.switch_on();
  const std::pair<const char*, const char*> cases[] = {
      {"", "JSON object"},
      {"{", "JSON object"},
      {"[1]", "JSON object"},
      {"\xff\xfe", "JSON object"},
      {"[[[[[[[[1]]]]]]]]", "four levels"},
      {"{}", "\"do\" is missing"},
      {R"({"do":1})", "must be a text"},
      {R"({"do":"dance"})", "not \"dance\""},
      {R"({"do":"jog","system":0,"axis":6,"percent":1})", "\"axis\" must be a number from 0 to 5"},
      {R"({"do":"jog","system":0,"axis":0.5,"percent":1})", "whole number"},
      {R"({"do":"jog","system":0,"axis":0,"percent":101})", "\"percent\""},
      {R"({"do":"jog","system":4,"axis":0,"percent":1})", "\"system\""},
      {R"({"do":"send","command":"fly","parameter":0,"payload":0})", "no command \"fly\""},
      {R"({"do":"send","command":"estop","parameter":0,"payload":0})", "no command \"estop\""},
      {R"({"do":"send","command":"heartbeat","parameter":1,"payload":7})", "by itself"},
      {R"({"do":"send","command":"servo","parameter":2,"payload":0})", "from 0 to 1"},
      {R"({"do":"send","command":"speed_override","parameter":0,"payload":0})", "from 100 to 10000"},
      {R"({"do":"move","path":"spiral","joints_deg":[0,0,0,0,0,0],"speed_percent":1})", "joints, line or arc"},
      {R"({"do":"move","path":"arc","joints_deg":[0,0,0,0,0,0],"speed_percent":1})", "\"via_mm\" is missing"},
      {R"({"do":"move","path":"joints","joints_deg":[0,0],"speed_percent":1})", "must be 6 numbers"},
      {R"({"do":"move","path":"joints","joints_deg":[0,0,0,0,0,1e9],"speed_percent":1})", "must be 6 numbers"},
      {R"({"do":"move","path":"joints","joints_deg":[0,0,0,0,0,0],"speed_percent":0})", "\"speed_percent\""},
      {R"({"do":"load","name":"a.txt","text":"x"})", "ends in .ngc"},
      {R"({"do":"load","name":"a.jbi","text":""})", "empty"},
      {R"({"do":"load","name":"a.jbi","text":"\u00e4"})", "not ASCII"},
      {R"({"do":"inverse","xyz_mm":[1,2],"from_deg":[0,0,0,0,0,0]})", "\"xyz_mm\" must be 3 numbers"},
      {R"({"do":"input","pin":17})", "from 1 to 16"},
      {R"({"do":"hold","which":"door","axis":1})", "limit_neg or estop"},
      {R"({"do":"hold","which":"home","axis":7})", "from 1 to 6"},
      {R"({"do":"fault","fault":1})", "must be an object"},
      {R"({"do":"fault","fault":{"kind":"rain"}})", "rain"},
      {R"({"do":"fault","fault":{"kind":"estop"}})", "duration_s"},
      {R"({"do":"fault","fault":{"kind":"estop","duration_s":-1}})", "duration_s"},
      {R"({"do":"fault","fault":{"kind":"estop","duration_s":1,"axis":1}})", "axis"},
      {R"({"do":"fault","fault":{"kind":"estop","duration_s":1,"at_s":0}})", "at_s"},
      {R"({"do":"fault","fault":{"kind":"estop","duration_s":1,"when":"move_begins","when_move":0}})",
       "waits for nothing"},
      {R"({"do":"fault","fault":{"kind":"estop","duration_s":[1]}})", "must be a number, a flag"},
      {R"({"do":"fault","fault":{"kind":"drive_alarm","axis":7,"duration_s":1}})", "axis"},
      {R"({"do":"forward","joints_deg":[0,0,0,0,0,null]})", "must be 6 numbers"},
  };
  for (const auto& [message, why] : cases) {
    EXPECT_THAT(page.ask(message).value("error", ""), HasSubstr(why)) << message;
  }
  page.pass(200);
  EXPECT_EQ(page.state()["state"], "ready");
  for (std::size_t joint = 1; joint <= 6; ++joint) EXPECT_EQ(page.joint(joint), 0);
}

}  // namespace
}  // namespace armature::cosim
