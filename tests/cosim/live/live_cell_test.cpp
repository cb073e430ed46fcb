// What a person does to the cell of a live session: inputs, switches, faults.
#include "cosim/live/live_cell.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cosim/live/live_faults.hpp"
#include "cosim/serial/serial_log.hpp"
#include "cosim/serial/silent_peer.hpp"
#include "cosim/text/text_file.hpp"
#include "tests/cosim/live/live_page.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

using nlohmann::json;
using test::live_scenario_of;
using test::LivePage;
using testing::HasSubstr;

TEST(LiveCell, AClickInvertsAnInputAndHoldsASwitch) {
  LivePage page{live_scenario_of("pendant_jog", "strict")};
  page.switch_on();
  const auto home_switch = [&page] { return (page.state()["lamps"]["home"].get<int>() >> 1 & 1) != 0; };
  const bool home = home_switch();
  page.ask(R"({"do":"input","pin":3})");
  page.ask(R"({"do":"hold","which":"home","axis":2})");
  page.pass(20);
  EXPECT_EQ(page.state()["lamps"]["inputs"], 0b100);
  EXPECT_EQ(page.state()["held"]["home"], 0b10);
  EXPECT_NE(home_switch(), home);
  page.ask(R"({"do":"input","pin":3})");
  page.ask(R"({"do":"hold","which":"home","axis":2})");
  page.ask(R"({"do":"hold","which":"estop"})");
  page.pass(200);
  EXPECT_EQ(page.state()["lamps"]["inputs"], 0);
  EXPECT_EQ(home_switch(), home);
  EXPECT_EQ(page.state()["held"], (json{{"home", 0}, {"limit_pos", 0}, {"limit_neg", 0}, {"estop", true}}));
  EXPECT_TRUE(page.state()["lamps"]["estop"].get<bool>());
  EXPECT_EQ(page.state()["state"], "estop");
  page.ask(R"({"do":"hold","which":"estop"})");
  page.pass(20);
  EXPECT_FALSE(page.state()["lamps"]["estop"].get<bool>());
}

TEST(LiveCell, TheEventsSayInWhichTickAFaultBeganAndEnded) {
  LivePage page{live_scenario_of("pendant_jog", "strict")};
  page.switch_on();
  const auto tick = page.session.now().value() / kTickCycles;
  EXPECT_EQ(page.ask(R"({"do":"fault","fault":{"kind":"drive_alarm","axis":2,"duration_s":0.01}})"), json{});
  page.pass(100);
  const std::string events = page.state()["events"].dump();
  EXPECT_THAT(events, HasSubstr("fault: drive_alarm of axis 2 for 0.01 s"));
  EXPECT_THAT(events, testing::AnyOf(HasSubstr(fmt::format("tick {}, warning", tick)),
                                     HasSubstr(fmt::format("tick {}, warning", tick - 1))));
  EXPECT_THAT(events, HasSubstr("fault ends: drive_alarm"));
  EXPECT_EQ(page.state()["state"], "alarm") << page.state();
}

// The digest of the run that the overrides and the recorded line describe.
std::string digest_of_repeated(const std::vector<std::string>& overrides, const std::filesystem::path& serial,
                               Cycles end) {
  const std::filesystem::path scenarios = ARMATURE_SOURCE_DIR "/scenarios";
  std::vector<std::string> all{"pendant.profile=\"strict\"", "move=[]", "expect={}", "duration_s=" + seconds_text(end)};
  all.insert(all.end(), overrides.begin(), overrides.end());
  Scenario scenario = load_scenario(scenarios / "pendant_jog",
                                    {.search_path = scenarios, .overrides = all, .logic = {.engine = Engine::kModel}});
  scenario.serial_sends = parse_serial_log(serial, read_text_file(serial, 1 << 20), *scenario.serial);
  SilentPeer nobody;
  Run run{scenario, {.serial_peer = &nobody}};
  while (run.advance(run.now() + to_cycles(0.1))) {
  }
  return run.finish().facts.sha256;
}

TEST(LiveCell, WhatWasClickedHappensAgainInTheRunThatRepeatsTheSession) {
  const test::TempFolder folder;
  const std::filesystem::path file = folder.path() / "serial.csv";
  std::string digest;
  std::vector<std::string> overrides;
  Cycles end{};
  {
    LivePage page{live_scenario_of("pendant_jog", "strict"), {.serial = file}};
    page.switch_on();
    page.hold_jog("1");
    page.pass(150);
    for (
        const char* const click :
        {R"({"do":"input","pin":3})", R"({"do":"input","pin":16})", R"({"do":"hold","which":"home","axis":4})",
         R"({"do":"fault","fault":{"kind":"pulse_loss","axis":2,"count":7}})",
         R"({"do":"fault","fault":{"kind":"encoder_noise","axis":3,"line":"a","width_us":2,"mean_gap_us":90,"duration_s":0.03}})",
         R"({"do":"input","pin":3})", R"({"do":"hold","which":"home","axis":4})",
         R"({"do":"hold","which":"limit_pos","axis":2})"}) {
      EXPECT_EQ(page.ask(click), json{}) << click;
      page.pass(24);
    }
    page.held.reset();
    page.pass(100);
    const SessionResult result = page.session.finish();
    end = result.cycles;
    digest = result.sha256;
    overrides = result.overrides;
  }
  EXPECT_THAT(overrides, testing::ElementsAre(HasSubstr("switch_stuck"), HasSubstr("pin=16,level=1")));
  EXPECT_THAT(overrides[0], testing::ContainsRegex("\"home\",level=[01],duration_s=0\\.09")) << "held for 96 ms";
  EXPECT_EQ(digest_of_repeated(overrides, file, end), digest);
  EXPECT_NE(digest_of_repeated({}, file, end), digest) << "the clicks change the run";
}

TEST(LiveFaults, TheSuggestedValuesOfEveryKindAreThoseOfAFaultInAScenario) {
  const Scenario scenario = live_scenario_of("pendant_jog", "strict");
  const Json kinds = fault_kinds_json(scenario.robot);
  constexpr std::size_t kInside = 2;  // of FaultInside: not offered
  EXPECT_EQ(kinds.size(), std::variant_size_v<FaultKind> - kInside);
  for (const Json& kind : kinds) {
    ConfigValue::Table table{{.key = "kind", .origin = {}, .value = {kind["kind"].get<std::string>(), {}}}};
    std::string text = "fault=[{at_s=0.1,kind=" + kind["kind"].dump();
    for (const Json& key : kind["keys"]) {
      const Json& value = key["value"];
      ConfigValue::Data data;
      if (value.is_string()) data = value.get<std::string>();
      if (value.is_number_integer()) data = value.get<std::int64_t>();
      if (value.is_number_float()) data = value.get<double>();
      table.push_back({.key = key["key"].get<std::string>(), .origin = {}, .value = {data, {}}});
      text += "," + key["key"].get<std::string>() + "=" + value.dump();
    }
    const FaultSpec fault = read_fault({std::move(table), {}}, scenario, to_cycles(0.1));
    const std::filesystem::path scenarios = ARMATURE_SOURCE_DIR "/scenarios";
    const Scenario written =
        load_scenario(scenarios / "pendant_jog", {.search_path = scenarios, .overrides = {text + "}]"}});
    ASSERT_EQ(written.faults.size(), 1u) << kind;
    EXPECT_EQ(written.faults[0].kind, fault.kind) << kind;
  }
}

}  // namespace
}  // namespace armature::cosim
