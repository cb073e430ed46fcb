// Motions that the pendant commands, on the verilated logic: what ends them when the operator or the line fails.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "controller/base/angle_units.hpp"
#include "controller/pendant/protocol/frame.hpp"
#include "cosim/kernel/scenario_soc.hpp"
#include "cosim/kernel/simulation.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "tests/cosim/pendant/blind_pendant.hpp"
#include "tests/support/silent_listener.hpp"

namespace armature::cosim {
namespace {

using pendant::Frame;
using pendant::Opcode;
using test::BlindPendant;
using test::ms;

// The set-points of joint 1.
class Joint1 final : public test::SilentListener {
 public:
  void on_row(TraceRow& row) override { deg.push_back(row.telemetry.reference[0].value() * kDegPerRad); }
  void on_event(const Event& event, Cycles) override {
    if (const auto* jog = std::get_if<JogEnded>(&event)) ended = jog->how;
  }

  // The last tick in which it moved.
  [[nodiscard]] std::size_t last_motion() const {
    std::size_t tick = deg.size() - 1;
    while (tick > 0 && deg[tick - 1] == deg.back()) --tick;
    return tick;
  }
  [[nodiscard]] double speed_deg_s(std::size_t tick) const { return (deg[tick] - deg[tick - 1]) / kTickSeconds; }

  std::vector<double> deg;
  std::optional<JogEnd> ended;
};

Scenario run_of(double duration_s) {
  const std::filesystem::path scenarios = ARMATURE_SOURCE_DIR "/scenarios";
  Scenario scenario = load_scenario(scenarios / "pendant_moves", {.search_path = scenarios, .overrides = {}});
  scenario.duration_s = duration_s;
  scenario.engine = Engine::kModel;
  return scenario;
}

Joint1 run(const Scenario& scenario, BlindPendant& peer) {
  Joint1 joint;
  const SimulationEnd end = test::run_to_end(Simulation{scenario, make_soc(scenario), joint, std::nullopt, &peer});
  EXPECT_EQ(end.reason, EndReason::kFinished) << end.failure;
  return joint;
}

TEST(PendantMotion, AJogWithoutARepetitionStopsWithinItsBrakingDistance) {
  const Scenario scenario = run_of(0.35);
  BlindPendant peer;
  for (const std::int64_t when : {30, 70, 110}) {
    peer.at(ms(when), Frame{.opcode = Opcode::kJogContinuous, .parameter = 0, .payload = 10'000});
  }
  const Joint1 joint = run(scenario, peer);
  EXPECT_EQ(joint.ended, JogEnd::kTimeOut);
  const AxisSpec& axis = scenario.robot.axes[0];
  const double speed = 0.25 * axis.max_speed_deg_s;  // the limit of jogs
  // The last command came at 110.7 ms, its time is over 100 ms later.
  constexpr std::size_t kOver = 2'107 * 2;
  EXPECT_NEAR(joint.speed_deg_s(kOver), speed, 0.01 * speed);
  const double braking_deg = speed * speed / (2 * axis.max_accel_deg_s2);
  EXPECT_LE(joint.deg.back() - joint.deg[kOver], 1.02 * braking_deg + speed * 0.0005);
  EXPECT_LE(static_cast<double>(joint.last_motion()), kOver + 20'000 * speed / axis.max_accel_deg_s2 + 20);
}

TEST(PendantMotion, AMoveStopsWhenThePendantIsSilentForHalfASecond) {
  BlindPendant peer;
  peer.at(ms(30), Frame{.opcode = Opcode::kJogLimit, .payload = 500});
  peer.at(ms(33), Frame{.opcode = Opcode::kJogIncrement, .parameter = 0, .payload = 400'000});
  const Joint1 joint = run(run_of(0.75), peer);
  // The last frame came at 33.7 ms.
  EXPECT_GT(joint.last_motion(), 20u * 533);
  EXPECT_LT(joint.last_motion(), 20u * 600);
}

TEST(PendantMotion, AMoveContinuesWhileThePendantSaysThatItIsThere) {
  BlindPendant peer;
  peer.at(ms(30), Frame{.opcode = Opcode::kJogLimit, .payload = 500});
  peer.at(ms(33), Frame{.opcode = Opcode::kJogIncrement, .parameter = 0, .payload = 400'000});
  peer.at(ms(400), Frame{.opcode = Opcode::kHeartbeat});
  const Joint1 joint = run(run_of(0.75), peer);
  EXPECT_EQ(joint.last_motion(), joint.deg.size() - 1);
}

TEST(PendantMotion, AJogNeverPassesASoftLimit) {
  Scenario scenario = run_of(0.5);
  scenario.robot.axes[0].max_deg = 5;
  BlindPendant peer;
  peer.at(ms(30), Frame{.opcode = Opcode::kJogLimit, .payload = 10'000});
  for (std::int64_t when = 40; when < 400; when += 40) {
    peer.at(ms(when), Frame{.opcode = Opcode::kJogContinuous, .parameter = 0, .payload = 10'000});
  }
  const Joint1 joint = run(scenario, peer);
  EXPECT_EQ(joint.ended, JogEnd::kLimit);
  EXPECT_NEAR(joint.deg.back(), 5, 1e-9);
  for (const double deg : joint.deg) ASSERT_LE(deg, 5 + 1e-9);
}

}  // namespace
}  // namespace armature::cosim
