// A session without a browser: what messages of the page do with the simulated arm.
#include "cosim/live/live_session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "controller/base/angle_units.hpp"
#include "tests/cosim/live/live_page.hpp"

namespace armature::cosim {
namespace {

using nlohmann::json;
using test::live_scenario_of;
using test::LivePage;
using testing::HasSubstr;

TEST(LiveSession, AJogLastsAsLongAsTheKeyIsHeld) {
  LivePage page{live_scenario_of("pendant_jog", "strict")};
  page.switch_on();
  page.hold_jog("1");
  page.pass(500);
  EXPECT_EQ(page.state()["state"], "jog");
  const double deg = page.joint(2);
  EXPECT_GT(deg, 1);
  page.held.reset();
  page.ask(R"({"do":"release"})");
  page.pass(400);
  EXPECT_EQ(page.state()["state"], "ready");
  const double rest = page.joint(2);
  page.pass(300);
  EXPECT_EQ(page.joint(2), rest);
}

TEST(LiveSession, WithoutAPageTheArmStopsEvenWhenTheKeyIsHeld) {
  LivePage page{live_scenario_of("pendant_jog", "strict")};
  page.switch_on();
  page.hold_jog("1");
  page.pass(500);
  page.session.on_closed();
  page.held.reset();
  page.alive = false;
  page.pass(400);
  EXPECT_EQ(page.state()["state"], "ready");
  EXPECT_THAT(page.state()["messages"].dump(), HasSubstr("stop: ok"));
}

TEST(LiveSession, AFrozenPageStopsAMove) {
  LivePage page{live_scenario_of("pendant_jog", "strict")};
  page.switch_on();
  EXPECT_EQ(page.ask(R"({"do":"move","path":"joints","joints_deg":[150,0,0,0,0,0],"speed_percent":20})"), json{});
  page.pass(600);
  EXPECT_EQ(page.state()["state"], "move");
  page.alive = false;
  page.pass(2'500);
  EXPECT_EQ(page.state()["state"], "ready");
  const double deg = page.joint(1);
  EXPECT_LT(deg, 89);
  page.alive = true;
  page.pass(500);
  EXPECT_EQ(page.joint(1), deg) << "it does not continue by itself";
}

TEST(LiveSession, AfterTheOperatorWasAwayAHeldKeyMustBeReleasedFirst) {
  LivePage page{live_scenario_of("pendant_jog", "strict")};
  page.switch_on();
  page.hold_jog("1");
  page.pass(300);
  const std::string key = *std::exchange(page.held, std::nullopt);
  page.alive = false;
  page.pass(1'500);
  page.alive = true;
  page.held = key;
  const double deg = page.joint(2);
  page.pass(500);
  EXPECT_EQ(page.joint(2), deg);
  page.hold_jog("1");
  page.pass(500);
  EXPECT_GT(page.joint(2), deg + 0.5);
}

// The state in which a program ends without a page.
json state_of_program_without_a_page(const std::string& profile) {
  LivePage page{live_scenario_of("job_pick_and_place", profile)};
  page.switch_on();
  page.ask(R"({"do":"run","mode":0,"line":0})");
  page.pass(600);
  EXPECT_EQ(page.state()["state"], "run") << page.state();
  page.alive = false;
  page.pass(2'500);
  return page.state()["state"];
}

TEST(LiveSession, AProgramIsHeldWithoutAPage) {
  EXPECT_EQ(state_of_program_without_a_page("extended"), "hold");
}

TEST(LiveSession, WithTheStrictProfileOnlyTheEmergencyStopEndsAProgram) {
  EXPECT_EQ(state_of_program_without_a_page("strict"), "estop");
}

TEST(LiveSession, MovesToTheAnglesThatItWasGiven) {
  LivePage page{live_scenario_of("pendant_jog", "strict")};
  page.switch_on();
  page.ask(R"({"do":"move","path":"joints","joints_deg":[10,-5,15,20,30,-40],"speed_percent":50})");
  page.pass(3'000);
  const double wanted[] = {10, -5, 15, 20, 30, -40};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(page.joint(i + 1), wanted[i], 0.01) << i;
  const json tool = page.state()["tool"];
  json up = {{"do", "move"},
             {"path", "line"},
             {"xyz_mm", tool["xyz_mm"]},
             {"rpy_deg", tool["rpy_deg"]},
             {"speed_percent", 50}};
  up["xyz_mm"][2] = tool["xyz_mm"][2].get<double>() + 20;
  page.ask(up.dump());
  page.pass(3'000);
  EXPECT_NEAR(page.state()["tool"]["xyz_mm"][2].get<double>(), up["xyz_mm"][2].get<double>(), 0.02);
}

TEST(LiveSession, MovesOnAnArcThroughItsViaPoint) {
  LivePage page{live_scenario_of("pendant_jog", "strict")};
  page.switch_on();
  page.ask(R"({"do":"move","path":"joints","joints_deg":[10,-5,15,20,30,-40],"speed_percent":100})");
  page.pass(1'500);
  const json start = page.state()["tool"];
  const auto beside = [&start](double y, double z) {
    json point = start["xyz_mm"];
    point[1] = point[1].get<double>() + y;
    point[2] = point[2].get<double>() + z;
    return point;
  };
  const json via = beside(15, 15), end = beside(30, 0);
  const json arc = {
      {"do", "move"},       {"path", "arc"}, {"via_mm", via}, {"xyz_mm", end}, {"rpy_deg", start["rpy_deg"]},
      {"speed_percent", 20}};
  EXPECT_EQ(page.ask(arc.dump()), json{});
  const auto distance = [&page](const json& point) {
    double sum = 0;
    const json tool = page.state()["tool"]["xyz_mm"];
    for (std::size_t i = 0; i < 3; ++i) sum += std::pow(tool[i].get<double>() - point[i].get<double>(), 2);
    return std::sqrt(sum);
  };
  double nearest_mm = distance(via);
  for (int i = 0; i < 300; ++i) {
    page.pass(6);
    nearest_mm = std::min(nearest_mm, distance(via));
  }
  EXPECT_LT(nearest_mm, 1);
  EXPECT_LT(distance(end), 0.02);
}

TEST(LiveSession, TheEmergencyStopIsLatchedUntilItIsReset) {
  LivePage page{live_scenario_of("pendant_jog", "strict")};
  page.switch_on();
  page.hold_jog("0");
  page.pass(300);
  page.ask(R"({"do":"estop"})");
  page.held.reset();
  page.pass(300);
  EXPECT_EQ(page.state()["state"], "estop");
  EXPECT_FALSE(page.state()["drives"].get<bool>());
  page.ask(R"({"do":"send","command":"estop_reset","parameter":90,"payload":939785})");
  page.ask(R"({"do":"send","command":"reset_alarm","parameter":0,"payload":0})");
  page.pass(300);
  EXPECT_EQ(page.state()["state"], "idle");
}

TEST(LiveSession, KeepsNothingOfTheLineSoThatItDoesNotGrow) {
  test::PlainPage page{live_scenario_of("pendant_jog", "strict")};
  page.switch_on();
  EXPECT_TRUE(page.session.run().facts().serial_sent.empty());
}

}  // namespace
}  // namespace armature::cosim
