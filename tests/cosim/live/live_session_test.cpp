// A session without a browser: what messages of the page do with the simulated arm.
#include "cosim/live/live_session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "controller/base/angle_units.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

using nlohmann::json;
using testing::HasSubstr;

Scenario scenario_of(const std::string& name, const std::string& profile) {
  const std::filesystem::path scenarios = ARMATURE_SOURCE_DIR "/scenarios";
  Scenario scenario =
      load_scenario(scenarios / name, {.search_path = scenarios,
                                       .overrides = {"pendant.profile=\"" + profile + "\"", "move=[]", "expect={}"},
                                       .logic = {.engine = Engine::kModel}});
  scenario.duration_s = 3600;
  if (!scenario.serial) scenario.serial.emplace();
  return scenario;
}

// A page whose time passes as that of the simulation. It sends a beat every 100 ms while it is alive.
class Page {
 public:
  explicit Page(Scenario scenario) : scenario_{std::move(scenario)} {}

  void pass(int ms) {
    for (int i = 0; i < ms; i += kStep_ms) {
      now_ += std::chrono::milliseconds{kStep_ms};
      if (alive && i % 100 == 0) static_cast<void>(session.on_message(R"({"do":"beat"})"));
      if (held && i % 50 == 0) static_cast<void>(session.on_message(*held));
      ASSERT_TRUE(session.advance(session.run().now() + to_cycles(kStep_ms * 1e-3)));
    }
  }
  json ask(const std::string& message) {
    const std::string answer = session.on_message(message);
    return answer.empty() ? json{} : json::parse(answer);
  }
  json state() { return json::parse(session.state(1.0)); }
  double joint(std::size_t number) { return state()["joints_deg"][number - 1].get<double>(); }
  void switch_on() {
    pass(200);
    EXPECT_EQ(ask(R"({"do":"send","command":"servo","parameter":1,"payload":0})"), json{});
    pass(400);
    EXPECT_EQ(state()["state"], "ready") << state();
  }
  // From the press of the key on; until it is released.
  void hold_jog(const std::string& axis) {
    ask(R"({"do":"release"})");
    held = R"({"do":"jog","system":0,"axis":)" + axis + R"(,"percent":50})";
  }

  bool alive = true;
  std::optional<std::string> held;

 private:
  static constexpr int kStep_ms = 2;
  Scenario scenario_;
  LiveSession::Clock::time_point now_{};

 public:
  LiveSession session{scenario_, [this] { return now_; }};
};

TEST(LiveSession, AJogLastsAsLongAsTheKeyIsHeld) {
  Page page{scenario_of("pendant_jog", "strict")};
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
  Page page{scenario_of("pendant_jog", "strict")};
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
  Page page{scenario_of("pendant_jog", "strict")};
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
  Page page{scenario_of("pendant_jog", "strict")};
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

TEST(LiveSession, AProgramIsHeldWithoutAPage) {
  Page page{scenario_of("job_pick_and_place", "extended")};
  page.switch_on();
  page.ask(R"({"do":"run","mode":0,"line":0})");
  page.pass(600);
  ASSERT_EQ(page.state()["state"], "run") << page.state();
  page.alive = false;
  page.pass(2'500);
  EXPECT_EQ(page.state()["state"], "hold");
}

TEST(LiveSession, WithTheStrictProfileOnlyTheEmergencyStopEndsAProgram) {
  Page page{scenario_of("job_pick_and_place", "strict")};
  page.switch_on();
  page.ask(R"({"do":"run","mode":0,"line":0})");
  page.pass(600);
  ASSERT_EQ(page.state()["state"], "run") << page.state();
  page.alive = false;
  page.pass(2'500);
  EXPECT_EQ(page.state()["state"], "estop");
}

TEST(LiveSession, MovesToTheAnglesThatItWasGiven) {
  Page page{scenario_of("pendant_jog", "strict")};
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

TEST(LiveSession, TheEmergencyStopIsLatchedUntilItIsReset) {
  Page page{scenario_of("pendant_jog", "strict")};
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
  Page page{scenario_of("pendant_jog", "strict")};
  page.switch_on();
  EXPECT_TRUE(page.session.run().facts().serial_sent.empty());
}

TEST(LiveSession, MalformedMessagesGetAnErrorAndDoNothing) {
  Page page{scenario_of("pendant_jog", "strict")};
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
      {R"({"do":"move","path":"arc","joints_deg":[0,0,0,0,0,0],"speed_percent":1})", "joints or line"},
      {R"({"do":"move","path":"joints","joints_deg":[0,0],"speed_percent":1})", "must be 6 numbers"},
      {R"({"do":"move","path":"joints","joints_deg":[0,0,0,0,0,1e9],"speed_percent":1})", "must be 6 numbers"},
      {R"({"do":"move","path":"joints","joints_deg":[0,0,0,0,0,0],"speed_percent":0})", "\"speed_percent\""},
      {R"({"do":"load","name":"a.txt","text":"x"})", "ends in .ngc"},
      {R"({"do":"load","name":"a.jbi","text":""})", "empty"},
      {R"({"do":"load","name":"a.jbi","text":"\u00e4"})", "not ASCII"},
      {R"({"do":"inverse","xyz_mm":[1,2],"from_deg":[0,0,0,0,0,0]})", "\"xyz_mm\" must be 3 numbers"},
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
