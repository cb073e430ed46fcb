// A page without a browser, at a live session of a shipped scenario.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "cosim/live/live_session.hpp"
#include "cosim/live/past/reversible_session.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim::test {

inline Scenario live_scenario_of(const std::string& name, const std::string& profile) {
  const std::filesystem::path scenarios = ARMATURE_SOURCE_DIR "/scenarios";
  Scenario scenario =
      load_scenario(scenarios / name, {.search_path = scenarios,
                                       .overrides = {"pendant.profile=\"" + profile + "\"", "move=[]", "expect={}"},
                                       .logic = {.engine = Engine::kModel}});
  scenario.duration_s = 3600;
  if (!scenario.serial) scenario.serial.emplace();
  return scenario;
}

// A page whose time passes as that of the simulation. It sends a beat every 100 ms while it is alive. `Session`: a
// LiveSession, or a ReversibleSession, which knows by the time whether the page is alive.
template <class Session>
class PageOf {
 public:
  explicit PageOf(Scenario scenario, const SessionFiles& files = {}) : scenario_{std::move(scenario)}, files_{files} {}

  void pass(int ms) {
    for (int i = 0; i < ms; i += kStep_ms) {
      now_ += std::chrono::milliseconds{kStep_ms};
      if (alive && i % 100 == 0) static_cast<void>(session.on_message(R"({"do":"beat"})"));
      if (held && i % 50 == 0) static_cast<void>(session.on_message(*held));
      ASSERT_TRUE(session.advance(session.now() + to_cycles(kStep_ms * 1e-3)));
    }
  }
  nlohmann::json ask(const std::string& message) {
    const std::string answer = session.on_message(message);
    return answer.empty() ? nlohmann::json{} : nlohmann::json::parse(answer);
  }
  nlohmann::json state() { return nlohmann::json::parse(session.state(1.0)); }
  double joint(std::size_t number) { return double{state()["joints_deg"][number - 1]}; }
  void switch_on() {
    pass(200);
    EXPECT_EQ(ask(R"({"do":"send","command":"servo","parameter":1,"payload":0})"), nlohmann::json{});
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
  SessionFiles files_;
  ReversibleSession::Clock::time_point now_{};

  Session make() {
    if constexpr (std::is_same_v<Session, LiveSession>) {
      return Session{scenario_};
    } else {
      return Session{scenario_, files_, [this] { return now_; }};
    }
  }

 public:
  Session session = make();
};

using LivePage = PageOf<ReversibleSession>;
using PlainPage = PageOf<LiveSession>;

}  // namespace armature::cosim::test
