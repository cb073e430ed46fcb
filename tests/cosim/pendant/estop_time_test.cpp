// The emergency stop of the pendant on the verilated logic: every byte crosses the UART bit by bit. The pulses must end
// within a millisecond after the line begins to send it, whatever the arm does and however full the UART's buffer is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <tuple>
#include <vector>

#include "controller/pendant/parts/estop_detector.hpp"
#include "controller/pendant/protocol/command_link.hpp"
#include "controller/pendant/protocol/frame.hpp"
#include "cosim/kernel/scenario_soc.hpp"
#include "cosim/kernel/simulation.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "cosim/time/clock.hpp"
#include "tests/cosim/pendant/blind_pendant.hpp"
#include "tests/support/silent_listener.hpp"

namespace armature::cosim {
namespace {

using pendant::Frame;
using pendant::Opcode;
using test::BlindPendant;
using test::kMs;
using test::ms;

// When the emergency stop began on the line, and when the last pulse came.
class StopWatch final : public test::SilentListener {
 public:
  void on_row(TraceRow& row) override {
    moved_before_ = moved_before_ || (!began_ && row.pin_pulses != before_);
    if (row.pin_pulses != before_) last_change_ = Cycles{row.cycle};
    before_ = row.pin_pulses;
    state_ = row.telemetry.state;
    if (!began_) state_before = row.telemetry.state;
  }
  void on_signal(const Signal& signal, Cycles now) override {
    if (const auto* byte = std::get_if<SerialEvent>(&signal)) {
      if (byte->direction == SerialDirection::kRx && byte->byte == pendant::kEstopByte && !began_) began_ = byte->at;
    }
    const auto* enables = std::get_if<ServoEnables>(&signal);
    if (enables != nullptr && enables->levels == 0 && began_) drives_off_ = now;
  }

  [[nodiscard]] bool moved_before() const { return moved_before_; }
  [[nodiscard]] Cycles drives_off_after() const { return drives_off_ - *began_; }
  // A row counts the pulses up to its trigger.
  [[nodiscard]] Cycles last_pulse_after() const { return last_change_ - *began_; }
  [[nodiscard]] MotionState state() const { return state_; }

  MotionState state_before = MotionState::kIdle;

 private:
  PerAxis<std::int64_t> before_{};
  bool moved_before_ = false;
  std::optional<Cycles> began_;
  Cycles last_change_{};
  Cycles drives_off_{};
  MotionState state_ = MotionState::kIdle;
};

enum class Motion { kJog, kJointMove, kLine, kHeld, kProgram, kNone };

Scenario scenario_with(Motion motion) {
  const std::filesystem::path scenarios = ARMATURE_SOURCE_DIR "/scenarios";
  const std::filesystem::path name = motion == Motion::kProgram ? "estop_during_program" : "pendant_moves";
  Scenario scenario = load_scenario(scenarios / name, {.search_path = scenarios, .overrides = {}});
  scenario.duration_s = 0.075;
  scenario.engine = Engine::kModel;
  scenario.moves.clear();
  if (motion == Motion::kHeld) {
    scenario.moves.push_back({.at_s = 0.055, .kind = HoldSpec{}});
  }
  return scenario;
}

class PendantEstop : public testing::TestWithParam<std::tuple<Motion, std::size_t>> {};

TEST_P(PendantEstop, EndsThePulsesWithinAMillisecond) {
  const auto [motion, stale] = GetParam();
  BlindPendant peer;
  if (motion == Motion::kJog) {
    peer.at(ms(20), Frame{.opcode = Opcode::kJogContinuous, .parameter = 0, .payload = 10'000});
  } else if (motion == Motion::kLine) {
    peer.at(ms(20), Frame{.opcode = Opcode::kSetCoordinates, .parameter = 1});
    peer.at(ms(23), Frame{.opcode = Opcode::kJogIncrement, .parameter = 2, .payload = -20'000});
  } else if (motion == Motion::kProgram) {
    peer.at(ms(23), Frame{.opcode = Opcode::kRun});
  } else if (motion != Motion::kNone) {
    peer.at(ms(20), Frame{.opcode = Opcode::kJogIncrement, .parameter = 0, .payload = 40'000});
  }
  // Bytes of no frame fill the buffer of the UART to each level below its trigger.
  std::vector<std::uint8_t> bytes(stale, 0x55);
  bytes.insert(bytes.end(), pendant::kEstopBytes, pendant::kEstopByte);
  peer.at(ms(60), bytes);

  StopWatch watch;
  const Scenario scenario = scenario_with(motion);
  const SimulationEnd end = test::run_to_end(Simulation{scenario, make_soc(scenario), watch, std::nullopt, &peer});

  ASSERT_EQ(end.reason, EndReason::kFinished) << end.failure;
  EXPECT_EQ(watch.moved_before(), motion != Motion::kNone);
  EXPECT_EQ(watch.state(), MotionState::kFault);
  EXPECT_GT(watch.drives_off_after(), Cycles{0});
  EXPECT_LE(watch.last_pulse_after(), kMs + armature::kTickCycles);
  const pendant::FrameBytes reply = encode(Frame{.kind = pendant::Kind::kReply, .opcode = Opcode::kEstop});
  EXPECT_NE(std::search(peer.got.begin(), peer.got.end(), reply.begin(), reply.end()), peer.got.end());
  RecordProperty("us", static_cast<int>(watch.drives_off_after().value() / 50));
}

INSTANTIATE_TEST_SUITE_P(EveryFill, PendantEstop,
                         testing::Combine(testing::Values(Motion::kJog, Motion::kJointMove, Motion::kLine,
                                                          Motion::kHeld, Motion::kProgram, Motion::kNone),
                                          testing::Range(std::size_t{0}, std::size_t{8})));

}  // namespace
}  // namespace armature::cosim
