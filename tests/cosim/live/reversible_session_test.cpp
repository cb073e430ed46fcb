// Going back in a live session, and going on from there.
#include "cosim/live/past/reversible_session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cosim/text/text_file.hpp"
#include "tests/cosim/live/live_page.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

using nlohmann::json;
using test::live_scenario_of;
using test::LivePage;
using testing::HasSubstr;

std::string text_of(const std::filesystem::path& file) {
  return read_text_file(file, 1 << 24);
}

SessionFiles files_in(const test::TempFolder& folder) {
  return {.serial = folder.path() / "serial.csv", .log = folder.path() / "log.txt"};
}

// What the page shows, without what depends on where the end is.
json shown(LivePage& page) {
  json state = page.state();
  state.erase("bar");
  return state;
}

void look(LivePage& page, double t_s) {
  EXPECT_EQ(page.ask(R"({"do":"look","t_s":)" + std::to_string(t_s) + "}"), json{});
  while (page.session.is_on_the_way()) ASSERT_TRUE(page.session.advance(Cycles{}));
}

// Servo on, a jog, a fault, an input: 1.5 s.
void begin(LivePage& page) {
  page.switch_on();
  page.hold_jog("1");
  page.pass(300);
  page.ask(R"({"do":"input","pin":3})");
  page.held.reset();
  page.ask(R"({"do":"release"})");
  page.pass(300);
  page.ask(R"({"do":"fault","fault":{"kind":"pulse_loss","axis":2,"count":3}})");
  page.ask(R"({"do":"move","path":"joints","joints_deg":[5,0,0,0,0,0],"speed_percent":100})");
  page.pass(300);
}

TEST(ReversibleSession, AMomentThatIsLookedAtIsShownAsItWas) {
  LivePage page{live_scenario_of("pendant_jog", "strict")};
  std::vector<std::pair<double, json>> moments;
  page.switch_on();
  page.hold_jog("1");
  for (int i = 0; i < 6; ++i) {
    page.pass(70);
    moments.emplace_back(to_seconds(page.session.now()), shown(page));
  }
  const json end = shown(page);
  for (const std::size_t i : {4u, 1u, 3u, 0u, 5u}) {
    look(page, moments[i].first);
    EXPECT_EQ(shown(page), moments[i].second) << i;
    EXPECT_TRUE(page.state()["bar"]["looking"].get<bool>());
  }
  EXPECT_EQ(page.state()["bar"]["end_s"], to_seconds(page.session.now()));
  EXPECT_EQ(shown(page), end);
}

TEST(ReversibleSession, TimeStandsStillAndNothingIsCommandedWhileThePastIsShown) {
  LivePage page{live_scenario_of("pendant_jog", "strict")};
  begin(page);
  look(page, 0.7);
  const json state = page.state();
  page.pass(3'000);
  EXPECT_EQ(page.state(), state);
  EXPECT_THAT(page.ask(R"({"do":"estop"})").value("error", ""), HasSubstr("the past is shown"));
  EXPECT_TRUE(page.ask(R"({"do":"forward","joints_deg":[0,0,0,0,0,0]})").contains("forward"));
  EXPECT_THAT(page.ask(R"({"do":"look","t_s":100})").value("error", ""), HasSubstr("\"t_s\""));
  page.session.on_closed();
  EXPECT_EQ(page.state(), state);
}

// The same as a session that did the same without going back: what came after the moment has left no trace.
TEST(ReversibleSession, GoingOnFromAMomentIsABranchWithoutWhatCameAfterIt) {
  const test::TempFolder folder, direct_folder;
  const SessionFiles files = files_in(folder), direct_files = files_in(direct_folder);
  const auto go_on = [](LivePage& page) {
    page.ask(R"({"do":"input","pin":4})");
    page.hold_jog("3");
    page.pass(200);
    return page.session.finish();
  };
  LivePage page{live_scenario_of("pendant_jog", "strict"), files};
  begin(page);
  look(page, 0.6);
  look(page, 0.75);
  page.ask(R"({"do":"live"})");
  EXPECT_FALSE(page.session.is_looking());
  const SessionResult result = go_on(page);

  LivePage direct{live_scenario_of("pendant_jog", "strict"), direct_files};
  direct.switch_on();
  direct.hold_jog("1");
  direct.pass(150);
  const SessionResult expected = go_on(direct);
  EXPECT_EQ(result.cycles, expected.cycles);
  EXPECT_EQ(result.sha256, expected.sha256);
  EXPECT_EQ(result.overrides, expected.overrides);
  EXPECT_EQ(text_of(files.serial), text_of(direct_files.serial));
  EXPECT_EQ(text_of(files.log), text_of(direct_files.log));
}

TEST(ReversibleSession, GoingOnFromTheEndIsAsIfNobodyHadLooked) {
  LivePage page{live_scenario_of("pendant_jog", "strict")}, direct{live_scenario_of("pendant_jog", "strict")};
  for (LivePage* one : {&page, &direct}) begin(*one);
  page.ask(R"({"do":"input","pin":9})");
  direct.ask(R"({"do":"input","pin":9})");
  const double end_s = to_seconds(page.session.now());
  look(page, 0.3);
  page.ask(R"({"do":"look","t_s":)" + std::to_string(end_s) + "}");
  page.ask(R"({"do":"live"})");  // at the end of the way
  EXPECT_TRUE(page.session.is_looking());
  while (page.session.is_on_the_way()) ASSERT_TRUE(page.session.advance(Cycles{}));
  EXPECT_FALSE(page.session.is_looking());
  for (LivePage* one : {&page, &direct}) one->pass(100);
  EXPECT_EQ(page.session.finish().sha256, direct.session.finish().sha256);
}

TEST(ReversibleSession, AfterGoingBackToATimeWithoutAPageThePageIsThere) {
  LivePage page{live_scenario_of("pendant_jog", "strict")};
  page.alive = false;
  page.pass(300);
  page.alive = true;
  page.switch_on();
  look(page, 0.2);
  page.ask(R"({"do":"live"})");
  page.switch_on();
}

}  // namespace
}  // namespace armature::cosim
